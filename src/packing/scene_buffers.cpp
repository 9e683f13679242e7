// SPDX-License-Identifier: MIT
#include "packing/scene_buffers.h"

#include <fmt/format.h>

#include <algorithm>

#include "packing/check_packed.h"
#include "packing/memory_estimate.h"

namespace strahl {
namespace {

template <typename T>
cl::Buffer upload(const Device& device, const std::vector<T>& values, const std::string& what) {
  cl::Buffer buffer = allocate(device, values.size() * sizeof(T), what);
  if (!values.empty()) write_buffer(device, buffer, values.data(), values.size() * sizeof(T));
  return buffer;
}

template <typename Real>
SceneBuffers upload_as(const Device& device, const Scene& scene, const Features& features, const PackOptions& options) {
  const PackedScene<Real> packed = pack_scene<Real>(scene, features, options);
  check_packed(packed, scene, features, options);
  const DeviceInfo& info = device.info();
  if (packed.bytes() > info.global_memory)
    throw NoDeviceError(fmt::format("the scene takes {} KiB, and {} has {}: choose {}", packed.bytes() >> 10,
                                    info.text(), info.memory_text(), info.room_for(packed.bytes())));
  SceneBuffers buffers;
  buffers.geometry = upload(device, packed.geometry, "the scene's geometry");
  buffers.shading = upload(device, packed.shading, "the scene's shading data");
  buffers.index = upload(device, packed.index, "the scene's tables");
  buffers.bytes = packed.bytes();
  buffers.tree = packed.tree;
  return buffers;
}

}  // namespace

cl::Buffer allocate(const Device& device, std::size_t bytes, const std::string& what) {
  bytes = std::max<std::size_t>(bytes, 16);
  if (bytes > device.info().max_allocation)
    throw NoDeviceError(fmt::format("{} needs a buffer of {} KiB, and {} allows {} KiB{}: choose {}", what, bytes >> 10,
                                    device.info().text(), device.info().max_allocation >> 10,
                                    device.info().is_memory_limited ? " with its --memory-limit" : "",
                                    device.info().room_for(bytes)));
  return checked(device.info().text(), [&] { return cl::Buffer(device.context(), CL_MEM_READ_WRITE, bytes); });
}

void write_buffer(const Device& device, const cl::Buffer& buffer, const void* data, std::size_t bytes) {
  checked(device.info().text(), [&] { return device.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes, data); });
}

void read_buffer(const Device& device, const cl::Buffer& buffer, void* data, std::size_t bytes, std::size_t offset) {
  checked(device.info().text(), [&] { return device.queue().enqueueReadBuffer(buffer, CL_TRUE, offset, bytes, data); });
}

SceneBuffers upload_scene(const Device& device, const Scene& scene, const Features& features, Precision precision,
                          const PackOptions& options) {
  PackOptions with_room = options;
  with_room.room = least_memory(scene, features, precision, options.lanes);
  require_memory(with_room.room, device.info(), precision);
  return precision == Precision::fp64 ? upload_as<double>(device, scene, features, with_room)
                                      : upload_as<float>(device, scene, features, with_room);
}

}  // namespace strahl
