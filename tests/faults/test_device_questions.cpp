// SPDX-License-Identifier: MIT
// A driver that has no answer to a question about a device: that device alone cannot be used, and where the question is
// of double precision, it has none.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.h"

using namespace strahl_test;
namespace fs = std::filesystem;

namespace {

constexpr const char* no_such_question = "-30";  // CL_INVALID_VALUE

nlohmann::json devices(const Folder& folder, std::map<std::string, std::string> environment) {
  fs::remove(folder.path("calls.log"));
  environment["RUSTICL_ENABLE"] = "llvmpipe";
  environment["OPENCL_LAYERS"] = STRAHL_FAIL_OPENCL;
  environment["STRAHL_CL_FAULT_LOG"] = folder.path("calls.log");
  const Outcome outcome = folder.run({"devices", "--json"}, environment);
  INFO(outcome.err);
  REQUIRE(outcome.signal == 0);
  return nlohmann::json::parse(outcome.out).at("platforms");
}

}  // namespace

TEST_CASE("a device without an answer is not usable, and its platform is not skipped") {
  const Folder folder;
  const nlohmann::json whole = devices(folder, {});
  std::vector<std::string> calls;
  std::istringstream log(read_text(folder.path("calls.log")));
  for (std::string line; std::getline(log, line);) calls.push_back(line);
  // Behind the half of them the default device is looked for, which asks all again.
  int unusable = 0, without_fp64 = 0, as_before = 0;
  for (std::size_t call = 1; call <= calls.size() / 2; ++call) {
    if (calls[call - 1] != "clGetDeviceInfo") continue;
    INFO("call " << call);
    const nlohmann::json now =
        devices(folder, {{"STRAHL_CL_FAULT_CALL", std::to_string(call)}, {"STRAHL_CL_FAULT_CODE", no_such_question}});
    REQUIRE(now.size() == whole.size());
    for (std::size_t i = 0; i < now.size(); ++i) {
      CHECK(now[i].at("skipped") == whole[i].at("skipped"));
      REQUIRE(now[i].at("devices").size() == whole[i].at("devices").size());
      for (std::size_t k = 0; k < now[i].at("devices").size(); ++k) {
        const nlohmann::json &device = now[i]["devices"][k], &before = whole[i]["devices"][k];
        if (device == before) {
          ++as_before;
        } else if (device.at("fault").is_string()) {
          ++unusable;
          CHECK(device.at("available") == false);
          CHECK(device.at("index") == before.at("index"));
        } else if (device.at("fp64") != before.at("fp64")) {
          ++without_fp64;
          CHECK(device.at("fp64") == false);
          CHECK(device.at("available") == true);
        }
      }
    }
  }
  CHECK(unusable > 10);
  CHECK(without_fp64 >= 1);
  CHECK(as_before > 10);
}
