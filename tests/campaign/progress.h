// SPDX-License-Identifier: MIT
// Long runs that can be stopped: what was done already.
//
// STRAHL_PROGRESS: a file that is told of every finished chunk, and says at the next start what need not be repeated.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "support/asked.h"

namespace strahl::test {

/// Counts of finished chunks by name, in a file or nowhere. Count: >> and << on one line.
template <class Count>
class Progress {
 public:
  Progress() : path_(std::getenv("STRAHL_PROGRESS") != nullptr ? std::getenv("STRAHL_PROGRESS") : "") {
    std::ifstream file(path_);
    for (std::string line, name; std::getline(file, line);) {
      std::istringstream words(line);
      Count count;
      if (words >> name >> count) done_[name] = count;
    }
  }
  [[nodiscard]] const Count* find(const std::string& name) const {
    const auto found = done_.find(name);
    return found == done_.end() ? nullptr : &found->second;
  }
  void finished(const std::string& name, const Count& count) const {
    if (!path_.empty()) std::ofstream(path_, std::ios::app) << name << ' ' << count << std::endl;
  }

 private:
  std::string path_;
  std::map<std::string, Count> done_;
};

}  // namespace strahl::test
