// SPDX-License-Identifier: MIT
// A layer for the OpenCL loader (CL/cl_layer.h; OPENCL_LAYERS names its file) that fails the n-th call of a program.
//
//   STRAHL_CL_FAULT_LOG    a line for each call: its name
//   STRAHL_CL_FAULT_CALL   n, from 1; without it all calls go through
//   STRAHL_CL_FAULT_CODE   what it returns, as -5; "hang": it never returns; "slow": it and those that
//                          follow, STRAHL_CL_FAULT_TIMES in all, go through after STRAHL_CL_FAULT_SECONDS each
//   STRAHL_CL_FAULT_NAME   only calls of this name count
//   STRAHL_CL_FAULT_QUEUE  only calls with a queue of the platform of this name count ("*": of any), and from the n-th
//                          on all fail: a device that is gone
#define CL_TARGET_OPENCL_VERSION 300
#include <CL/cl.h>
#include <CL/cl_icd.h>
#include <CL/cl_layer.h>
#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>
#include <tuple>
#include <type_traits>

namespace {

const cl_icd_dispatch* target = nullptr;
std::atomic<long> calls{0};

std::string text_of(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

/// The name of a queue's platform; empty where the call has no queue.
std::string platform_of(cl_command_queue queue) {
  cl_device_id device = nullptr;
  cl_platform_id platform = nullptr;
  char name[256] = "";
  if (target->clGetCommandQueueInfo(queue, CL_QUEUE_DEVICE, sizeof device, &device, nullptr) != CL_SUCCESS ||
      target->clGetDeviceInfo(device, CL_DEVICE_PLATFORM, sizeof platform, &platform, nullptr) != CL_SUCCESS ||
      target->clGetPlatformInfo(platform, CL_PLATFORM_NAME, sizeof name, name, nullptr) != CL_SUCCESS)
    std::abort();
  return name;
}
template <class First>
std::string platform_of(const First& /*no queue*/) {
  return {};
}

/// What this call shall return; CL_SUCCESS: what it returns.
cl_int fault_of(const char* call, const std::string& platform) {
  const std::string of_queue = text_of("STRAHL_CL_FAULT_QUEUE");
  if (!of_queue.empty() && (of_queue == "*" ? platform.empty() : platform != of_queue)) return CL_SUCCESS;
  if (const std::string only = text_of("STRAHL_CL_FAULT_NAME"); !only.empty() && only != call) return CL_SUCCESS;
  const long number = ++calls;
  if (const std::string log = text_of("STRAHL_CL_FAULT_LOG"); !log.empty()) {
    const std::string line = std::string(call) + "\n";
    const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    if (file < 0 || ::write(file, line.data(), line.size()) < 0) std::abort();
    ::close(file);
  }
  const std::string at = text_of("STRAHL_CL_FAULT_CALL"), code = text_of("STRAHL_CL_FAULT_CODE");
  if (at.empty()) return CL_SUCCESS;
  const long since = number - std::atol(at.c_str());
  if (code == "hang" && since == 0)
    while (true) ::pause();
  if (code == "slow" && since >= 0 && since < std::stol(text_of("STRAHL_CL_FAULT_TIMES")))
    std::this_thread::sleep_for(std::chrono::seconds(std::stoi(text_of("STRAHL_CL_FAULT_SECONDS"))));
  const bool is_it = of_queue.empty() ? since == 0 : since >= 0;
  return is_it ? std::atoi(code.c_str()) : CL_SUCCESS;  // 0 where the code is a word.
}

/// In place of a function of the dispatch: the code is returned, or goes where the last argument points.
template <auto member, const char* name, class Function = std::remove_cvref_t<decltype(target->*member)>>
struct Wrapped;

template <auto member, const char* name, class Result, class... Arguments>
struct Wrapped<member, name, Result (*)(Arguments...)> {
  static Result call(Arguments... arguments) {
    const cl_int fault = fault_of(name, platform_of(std::get<0>(std::make_tuple(arguments...))));
    if (fault == CL_SUCCESS) return (target->*member)(arguments...);
    if constexpr (std::is_same_v<Result, cl_int>) {
      return fault;
    } else {
      const auto all = std::make_tuple(arguments...);
      cl_int* code = std::get<sizeof...(Arguments) - 1>(all);
      if (code != nullptr) *code = fault;
      return nullptr;
    }
  }
};

cl_icd_dispatch wrapped;

#define CALL(function) constexpr char function##_name[] = #function;
#include "opencl_calls.def"
#undef CALL

}  // namespace

extern "C" {

CL_API_ENTRY cl_int CL_API_CALL clGetLayerInfo(cl_layer_info what, size_t size, void* value, size_t* needed) {
  if (what != CL_LAYER_API_VERSION) return CL_INVALID_VALUE;
  if (value != nullptr && size < sizeof(cl_layer_api_version)) return CL_INVALID_VALUE;
  if (value != nullptr) *static_cast<cl_layer_api_version*>(value) = CL_LAYER_API_VERSION_100;
  if (needed != nullptr) *needed = sizeof(cl_layer_api_version);
  return CL_SUCCESS;
}

CL_API_ENTRY cl_int CL_API_CALL clInitLayer(cl_uint count, const cl_icd_dispatch* below, cl_uint* count_here,
                                            const cl_icd_dispatch** here) {
  if (count < sizeof wrapped / sizeof wrapped.clGetPlatformIDs) return CL_INVALID_VALUE;
  target = below;
  wrapped = *below;
#define CALL(function) wrapped.function = &Wrapped<&cl_icd_dispatch::function, function##_name>::call;
#include "opencl_calls.def"
#undef CALL
  *count_here = sizeof wrapped / sizeof wrapped.clGetPlatformIDs;
  *here = &wrapped;
  return CL_SUCCESS;
}
}
