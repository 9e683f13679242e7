// SPDX-License-Identifier: MIT
// Parts of a picture's samples, added up: the same bits as one run, in any order.
#pragma once

#include <string>
#include <vector>

#include "checkpoint/checkpoint.h"

namespace strahl {

/// Reads and adds up the parts of one picture. Throws InputError, which names the files, where two parts are not of one
/// picture, overlap, are not finished, or leave samples between them out. is_whole: those before the first and behind
/// the last part are missed too.
[[nodiscard]] Checkpoint merged(const std::vector<std::string>& paths, bool is_whole);

}  // namespace strahl
