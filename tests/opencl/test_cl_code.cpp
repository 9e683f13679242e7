// SPDX-License-Identifier: MIT
// Names of OpenCL status codes against numbers copied from the specification.
#include <catch2/catch.hpp>

#include "opencl/cl_code.h"

using strahl::cl_code_name;

TEST_CASE("Status codes of every OpenCL version and of the loader have their names") {
  CHECK(cl_code_name(0) == "CL_SUCCESS");
  CHECK(cl_code_name(-1) == "CL_DEVICE_NOT_FOUND");
  CHECK(cl_code_name(-11) == "CL_BUILD_PROGRAM_FAILURE");
  CHECK(cl_code_name(-19) == "CL_KERNEL_ARG_INFO_NOT_AVAILABLE");
  CHECK(cl_code_name(-43) == "CL_INVALID_BUILD_OPTIONS");
  CHECK(cl_code_name(-68) == "CL_INVALID_DEVICE_PARTITION_COUNT");
  CHECK(cl_code_name(-70) == "CL_INVALID_DEVICE_QUEUE");
  CHECK(cl_code_name(-72) == "CL_MAX_SIZE_RESTRICTION_EXCEEDED");
  CHECK(cl_code_name(-1001) == "CL_PLATFORM_NOT_FOUND_KHR");
}

TEST_CASE("The core codes have no gap but the one that the specification leaves") {
  for (int code = 0; code >= -72; --code) {
    INFO(code);
    const bool unassigned = code < -19 && code > -30;
    CHECK((cl_code_name(code).rfind("unknown", 0) == 0) == unassigned);
  }
}

TEST_CASE("An unknown status keeps its number") { CHECK(cl_code_name(-1234) == "unknown OpenCL status -1234"); }
