// SPDX-License-Identifier: MIT
// All of the library: scenes from files or built in C++ (Scene, Camera, Shape, Sphere, Plane, Box, Triangle ...),
// pictures of them (Renderer, Image), and rays into them (Intersector, Ray, Hit). choose_tier() tells which precision a
// device can be trusted with, and which settings it needs. docs/example shows it at work.
#pragma once

#include "errors.h"
#include "image/image_io.h"
#include "image/metrics.h"
#include "image/npy.h"
#include "opencl/device.h"
#include "render/intersector.h"
#include "render/renderer.h"
#include "scene/loader.h"
#include "scene/meshes/mesh_file.h"
#include "scene/model/build.h"
#include "scene/validate.h"
#include "trust/tier_choice.h"
