#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace zmpwalk {

/// A mistake of the caller. Every message gives the value, the rule that it breaks, and what would have worked.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// A value breaks a rule: it is NaN, negative or out of range, or a name is unknown.
struct InputError : Error {
  using Error::Error;
};
/// An array has the wrong shape.
struct DimensionError : Error {
  using Error::Error;
};
/// A model or robot cannot be used. `what()` gives every reason, each on a line of its own.
struct ModelError : Error {
  explicit ModelError(std::vector<std::string> why) : Error(lines(why)), reasons(std::move(why)) {}
  explicit ModelError(std::string why) : ModelError(std::vector<std::string>{std::move(why)}) {}

  std::vector<std::string> reasons;

 private:
  static std::string lines(const std::vector<std::string>& why);
};

/// Throws DimensionError unless `got` equals `want`.
void require_size(const char* name, long got, long want);
/// Throws DimensionError unless a matrix is (rows, cols).
void require_shape(const char* name, long rows, long cols, long want_rows, long want_cols);
/// A number for a message; one of hundreds of digits is shortened.
std::string text_of(double value);
/// Throws InputError unless `value` is finite.
void require_finite(const char* name, double value);
/// Throws InputError unless `value` is finite and > 0.
void require_positive(const char* name, double value);

}  // namespace zmpwalk
