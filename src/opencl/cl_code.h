// SPDX-License-Identifier: MIT
// Symbolic names of OpenCL status codes.
#pragma once

#include <string>

namespace strahl {

/// "CL_INVALID_BUILD_OPTIONS", or "unknown OpenCL status -1234".
[[nodiscard]] std::string cl_code_name(int code);

}  // namespace strahl
