#include "zmpwalk/math/error.hpp"

#include <sstream>

namespace zmpwalk {

std::string text_of(double value) {
  if (std::isnan(value)) return "nan";
  if (std::abs(value) < 1e7) return std::to_string(value);
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string ModelError::lines(const std::vector<std::string>& why) {
  std::string text;
  for (const std::string& reason : why) text += (text.empty() ? "" : "\n") + reason;
  return text;
}

void require_size(const char* name, long got, long want) {
  if (got == want) return;
  throw DimensionError(std::string(name) + " has " + std::to_string(got) + " entries; it must have " +
                       std::to_string(want));
}

void require_shape(const char* name, long rows, long cols, long want_rows, long want_cols) {
  if (rows == want_rows && cols == want_cols) return;
  throw DimensionError(std::string(name) + " is (" + std::to_string(rows) + ", " + std::to_string(cols) +
                       "); it must be (" + std::to_string(want_rows) + ", " + std::to_string(want_cols) + ")");
}

void require_finite(const char* name, double value) {
  if (std::isfinite(value)) return;
  throw InputError(std::string(name) + " = " + text_of(value) + "; it must be a finite number");
}

void require_positive(const char* name, double value) {
  if (std::isfinite(value) && value > 0.0) return;
  throw InputError(std::string(name) + " = " + text_of(value) + "; it must be finite and greater than 0");
}

}  // namespace zmpwalk
