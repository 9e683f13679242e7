// SPDX-License-Identifier: MIT
// A scene in device memory, in the precision of a program.
#pragma once

#include "opencl/device.h"
#include "packing/pack.h"

namespace strahl {

struct SceneBuffers {
  cl::Buffer geometry, shading, index;
  std::size_t bytes = 0;  ///< Of all three together.
  TreeStats tree;
};

/// Packs and uploads. Throws NoDeviceError where the device cannot hold the scene.
[[nodiscard]] SceneBuffers upload_scene(const Device& device, const Scene& scene, const Features& features,
                                        Precision precision, const PackOptions& options);

/// A buffer of that many bytes (at least one, since OpenCL has no empty ones); NoDeviceError where it is too large.
[[nodiscard]] cl::Buffer allocate(const Device& device, std::size_t bytes, const std::string& what);

/// Blocking; `what` names the transfer in a DeviceError.
void write_buffer(const Device& device, const cl::Buffer& buffer, const void* data, std::size_t bytes);
void read_buffer(const Device& device, const cl::Buffer& buffer, void* data, std::size_t bytes, std::size_t offset = 0);

}  // namespace strahl
