# Targets for what comes from wheels: mujoco::mujoco, Eigen3::Eigen, eiquadprog_headers and, when that wheel is there,
# boost_headers.
# The Python interpreter is asked, at every configure, so that headers and library are those of the mujoco package
# that this very Python imports.

execute_process(
  COMMAND "${Python_EXECUTABLE}" "${CMAKE_CURRENT_LIST_DIR}/wheels.py"
  OUTPUT_VARIABLE wheels
  OUTPUT_STRIP_TRAILING_WHITESPACE
  RESULT_VARIABLE failed
)
if(failed)
  message(FATAL_ERROR "${Python_EXECUTABLE} could not run cmake/wheels.py")
endif()
string(REPLACE "\n" ";" wheels "${wheels}")
foreach(line IN LISTS wheels)
  string(REGEX MATCH "^([A-Z_]+)=(.*)$" _ "${line}")
  set(${CMAKE_MATCH_1} "${CMAKE_MATCH_2}")
endforeach()

if(NOT MUJOCO_DIR AND NOT ZMPWALK_ADAPTERS)
  message(FATAL_ERROR "no libmujoco for ${Python_EXECUTABLE}: pip install mujoco")
endif()
if(NOT EIGEN_INCLUDE_DIR)
  message(FATAL_ERROR "no Eigen headers for ${Python_EXECUTABLE}: pip install cmeel-eigen")
endif()
if(NOT EIQUADPROG_INCLUDE_DIR)
  message(FATAL_ERROR "no eiquadprog headers for ${Python_EXECUTABLE}: pip install eiquadprog")
endif()
message(STATUS "Eigen: ${EIGEN_INCLUDE_DIR}")

if(MUJOCO_DIR)
  message(STATUS "MuJoCo ${MUJOCO_VERSION}: ${MUJOCO_DIR}")
  add_library(mujoco::headers INTERFACE IMPORTED)
  set_target_properties(mujoco::headers PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${MUJOCO_DIR}/include")
  add_library(mujoco::mujoco SHARED IMPORTED)
  set_target_properties(mujoco::mujoco PROPERTIES IMPORTED_LOCATION "${MUJOCO_DIR}/${MUJOCO_LIBRARY}")
  target_link_libraries(mujoco::mujoco INTERFACE mujoco::headers)
endif()

add_library(Eigen3::Eigen INTERFACE IMPORTED)
set_target_properties(Eigen3::Eigen PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${EIGEN_INCLUDE_DIR}")

# Headers alone: templates of fixed size, which need no library when they run.
add_library(eiquadprog_headers INTERFACE IMPORTED)
set_target_properties(eiquadprog_headers PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${EIQUADPROG_INCLUDE_DIR}")

if(BOOST_INCLUDE_DIR)
  add_library(boost_headers INTERFACE IMPORTED)
  set_target_properties(boost_headers PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${BOOST_INCLUDE_DIR}")
endif()
