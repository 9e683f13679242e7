// SPDX-License-Identifier: MIT
// Two pictures of the program, bit by bit.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "cli/program.h"
#include "image/image_io.h"

namespace strahl_test {

/// Picture and told error.
inline void require_same_picture(const Folder& folder, const std::string& a, const std::string& b) {
  const strahl::Image one = strahl::read_image(folder.path(a)), other = strahl::read_image(folder.path(b));
  REQUIRE(one.channels == other.channels);
  CHECK(one.data == other.data);
  REQUIRE(one.metadata.count("rmse") == 1);
  CHECK(one.metadata.at("rmse") == other.metadata.at("rmse"));
}

}  // namespace strahl_test
