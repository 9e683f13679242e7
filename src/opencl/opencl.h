// SPDX-License-Identifier: MIT
// The one place that includes the OpenCL C++ bindings; every failing call throws cl::Error, turned into DeviceError
// by checked(). The host calls nothing beyond OpenCL 1.2, so that any driver since 2011 will do.
#pragma once

#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#include <CL/opencl.hpp>
#include <string>
#include <utility>

#include "errors.h"

namespace strahl {

/// Runs `call` and turns cl::Error into a DeviceError that names the call, the symbolic code and the device.
template <typename Call>
auto checked(const std::string& device, Call&& call) -> decltype(std::forward<Call>(call)()) {
  try {
    return std::forward<Call>(call)();
  } catch (const cl::Error& error) {
    throw DeviceError(error.what(), error.err(), device);
  }
}

}  // namespace strahl
