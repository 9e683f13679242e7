// SPDX-License-Identifier: MIT
// The study of `strahl tradeoff` as one page for the browser, with everything that it shows inside it.
#pragma once

#include <map>
#include <string>

namespace strahl {

/// tradeoff_json: what tradeoff.json holds (docs/tradeoff.md). pictures: the bytes of PNG files under the names by
/// which tradeoff_json calls them ("points/ID.png"); others are left out. The page asks nothing of a network, and is a
/// few kilobytes larger than 4/3 of its pictures. Throws InputError where tradeoff_json is not JSON, has no points, or
/// names a picture that is not there.
[[nodiscard]] std::string html_report(const std::string& tradeoff_json,
                                      const std::map<std::string, std::string>& pictures);

}  // namespace strahl
