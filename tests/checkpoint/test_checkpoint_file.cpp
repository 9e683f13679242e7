// SPDX-License-Identifier: MIT
// A checkpoint comes back as it was written; one that is cut anywhere, or has any byte changed, is refused. What films
// lack is found as rectangles.
#include <algorithm>
#include <catch2/catch.hpp>

#include "checkpoint/checkpoint.h"
#include "checkpoint/merge.h"
#include "image/file_bytes.h"
#include "image/temporary_folder.h"
#include "packing/cl_layout.h"

using namespace strahl;
using namespace strahl::test;
using Catch::Matchers::Contains;

namespace {

Checkpoint small_checkpoint(int first_sample = 3) {
  FilmSums film({FilmKind::pixels, 3, 2, {4, 2, 1}, 0, 0.1});
  film.first_sample = first_sample;
  for (std::size_t i = 0; i < film.words.size(); ++i) film.words[i] = static_cast<std::int64_t>(i * 0x123456789abcdefU);
  film.samples = {5, 5, 5, 5, 4, 4};
  Checkpoint checkpoint{{}, {film, {8, 12, 0.1}, {1, 2, 3, 4}, {}, {}, {{0.1, -2e-300, 3}, 0.25}}};
  checkpoint.header.identity.parts = {{"the seed", "7", ""}, {"a file", "abc", " (\xff name)"}};
  checkpoint.header.metadata = {{"scene", "s.xml"}};
  checkpoint.header.aovs = {"depth"};
  checkpoint.header.named_aovs = {{"dd.y", Aov::depth}, {"nn", Aov::normal}};
  checkpoint.header.spp = 64;
  checkpoint.state.aov_reals.assign(6 * layout::AOV_REALS, 1 / 3.0);
  checkpoint.state.aov_ints.assign(6 * layout::AOV_INTS, -1);
  checkpoint.told_of_film();
  return checkpoint;
}

}  // namespace

TEST_CASE("it comes back to the bit") {
  const TemporaryFolder folder;
  const Checkpoint out = small_checkpoint();
  write_checkpoint(folder / "c", out);
  CHECK(folder.names() == std::set<std::string>{"c"});
  const Checkpoint in = read_checkpoint(folder / "c");
  CHECK(in.state.film.words == out.state.film.words);
  CHECK(in.state.film.samples == out.state.film.samples);
  CHECK(in.state.film.first_sample == 3);
  CHECK(in.state.film.unit == out.state.film.unit);
  CHECK(in.state.film.sums.turn_bits == 1);
  CHECK(in.header.aovs == out.header.aovs);
  CHECK(in.header.named_aovs == out.header.named_aovs);
  CHECK(in.state.aov_reals == out.state.aov_reals);
  CHECK(in.state.aov_ints == out.state.aov_ints);
  CHECK(in.state.unusual == out.state.unusual);
  CHECK(in.state.position.done == 8);
  CHECK(in.state.position.check_at == 12);
  CHECK(in.state.position.max_error == 0.1);
  CHECK(in.state.frame.origin.y == -2e-300);
  CHECK(in.state.frame.scale == 0.25);
  CHECK(in.header.least == 4);
  CHECK(in.header.most == 5);
  CHECK(in.header.identity.difference_from(read_checkpoint_header(folder / "c").identity).empty());
  CHECK(in.header.metadata.at("scene") == "s.xml");
}

TEST_CASE("cut anywhere, or a byte changed anywhere, it is refused") {
  const TemporaryFolder folder;
  write_checkpoint(folder / "c", small_checkpoint());
  const std::string bytes = read_file(folder / "c");
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    std::filesystem::remove(folder / "cut");  // Writing over a file may wait for the disk.
    put_bytes(folder / "cut", bytes.substr(0, size));
    INFO(size);
    REQUIRE_THROWS_AS(read_checkpoint(folder / "cut"), InputError);
  }
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ (1 << at % 8));
    std::filesystem::remove(folder / "changed");
    put_bytes(folder / "changed", changed);
    INFO(at);
    REQUIRE_THROWS_AS(read_checkpoint(folder / "changed"), InputError);
  }
  put_bytes(folder / "longer", bytes + "x");
  CHECK_THROWS_WITH(read_checkpoint(folder / "longer"), Contains("bytes and should have"));
}

TEST_CASE("without AOVs, too") {
  const TemporaryFolder folder;
  Checkpoint out = small_checkpoint();
  out.state.aov_reals.clear();
  out.state.aov_ints.clear();
  // No program writes names of what is not there.
  write_checkpoint(folder / "plain", out);
  CHECK_THROWS_WITH(read_checkpoint(folder / "plain"), Contains("names AOVs and has none"));
  out.header.aovs.clear();
  write_checkpoint(folder / "named", out);
  CHECK_THROWS_WITH(read_checkpoint(folder / "named"), Contains("names AOVs and has none"));
  out.header.named_aovs.clear();
  write_checkpoint(folder / "c", out);
  CHECK(read_checkpoint(folder / "c").state.film.words == out.state.film.words);
}

TEST_CASE("second moments, and names of them where there are none") {
  const TemporaryFolder folder;
  Checkpoint out = small_checkpoint();
  out.header.named_aovs = {{"p", Aov::xyz}, {"m2_p", Aov::xyz_squared}};
  write_checkpoint(folder / "none", out);
  CHECK_THROWS_WITH(read_checkpoint(folder / "none"), Contains("names AOVs and has none"));
  out.state.film.has_squares = true;
  out.state.film.words.resize(out.state.film.words.size() / 4 * 5, 7);
  write_checkpoint(folder / "c", out);
  const Checkpoint in = read_checkpoint(folder / "c");
  CHECK(in.state.film.has_squares);
  CHECK(in.state.film.words == out.state.film.words);
  CHECK(in.header.named_aovs == out.header.named_aovs);
}

TEST_CASE("weights, and parts whose weights add up") {
  const TemporaryFolder folder;
  Checkpoint part = small_checkpoint(0);
  CHECK_FALSE(part.state.film.has_weights);
  FilmShape shape = part.state.film;
  shape.has_weights = true;
  shape.noise_overlap = 1.625;
  part.state.film = FilmSums(shape);
  FilmSums& film = part.state.film;
  std::fill(film.samples.begin(), film.samples.end(), 5);
  const std::size_t last = film.words_per_pixel() - 1;
  film.words[last] = (std::int64_t{7} << 32) | 0xffff;
  part.told_of_film();
  write_checkpoint(folder / "a", part);
  const FilmSums in = read_checkpoint(folder / "a").state.film;
  CHECK(in.has_weights);
  CHECK(in.noise_overlap == 1.625);
  CHECK(in.words == film.words);
  film.first_sample = 5;
  part.told_of_film();
  write_checkpoint(folder / "b", part);
  const FilmSums both = merged({folder / "a", folder / "b"}, false).state.film;
  CHECK(both.has_weights);
  CHECK(both.noise_overlap == 1.625);
  CHECK(both.words[last] == ((std::int64_t{14} << 32) | 0x1fffe));
  film.noise_overlap = 0.5;
  write_checkpoint(folder / "less", part);
  CHECK_THROWS_WITH(read_checkpoint_header(folder / "less"), Contains("is damaged"));
}

TEST_CASE("one of another layout is told apart from what is none") {
  const TemporaryFolder folder;
  write_checkpoint(folder / "c", small_checkpoint());
  std::string bytes = read_file(folder / "c");
  for (const char other : {'1', '2', '4'}) {
    bytes[7] = other;
    put_bytes(folder / "other", bytes);
    CHECK_THROWS_WITH(read_checkpoint(folder / "other"), Contains("of another version of strahl"));
    CHECK_THROWS_WITH(read_checkpoint_header(folder / "other"), Contains("of another version of strahl"));
  }
  bytes[0] = 'S';
  put_bytes(folder / "none", bytes);
  CHECK_THROWS_WITH(read_checkpoint(folder / "none"), Contains("is no checkpoint"));
}

TEST_CASE("a header that asks for more than there is takes no memory") {
  const TemporaryFolder folder;
  write_checkpoint(folder / "c", small_checkpoint());
  std::string bytes = read_file(folder / "c");
  const std::size_t at = bytes.find("\"width\": 3");
  REQUIRE(at != std::string::npos);
  // As long as before, so that nothing else moves.
  for (const char* other : {"\"width\":-3", "\"width\":99"}) {
    std::string changed = bytes;
    changed.replace(at, 10, other);
    put_bytes(folder / "changed", changed);
    CHECK_THROWS_WITH(read_checkpoint(folder / "changed"), Contains("is damaged"));
  }
  // Numbers that no integer can hold (found by fuzzing), and one with a fraction.
  const std::size_t spp = bytes.find("\"spp\": 64");
  REQUIRE(spp != std::string::npos);
  for (const char* other : {"\"spp\":9e99", "\"spp\": 6.5", "\"spp\": -64"}) {
    std::string changed = bytes;
    changed.replace(spp, 9, other);
    std::uint64_t size = 0;
    changed.copy(reinterpret_cast<char*>(&size), sizeof size, 8);
    ++size;  // Of the header: the number has one digit more.
    changed.replace(8, 8, reinterpret_cast<const char*>(&size), 8);
    put_bytes(folder / "number", changed);
    CHECK_THROWS_WITH(read_checkpoint_header(folder / "number"), Contains("is damaged"));
  }
  std::uint64_t huge = ~std::uint64_t{0};
  bytes.replace(8, 8, reinterpret_cast<const char*>(&huge), 8);
  put_bytes(folder / "huge", bytes);
  CHECK_THROWS_WITH(read_checkpoint(folder / "huge"), Contains("cut short"));
  CHECK_THROWS_WITH(read_checkpoint(folder.path()), Contains("it is a folder"));
}

TEST_CASE("what is not finished, or of another size, is no part") {
  const TemporaryFolder folder;
  Checkpoint part = small_checkpoint(0);
  write_checkpoint(folder / "unfinished", part);
  CHECK_THROWS_WITH(merged({folder / "unfinished"}, false), Contains("is not finished") && Contains("4 to 5"));
  std::fill(part.state.film.samples.begin(), part.state.film.samples.end(), 5);
  part.told_of_film();
  write_checkpoint(folder / "a", part);
  part.state.film.first_sample = 5;
  part.told_of_film();
  write_checkpoint(folder / "b", part);
  CHECK(merged({folder / "b", folder / "a"}, false).state.unusual.invalid == 4);
  CHECK(merged({folder / "b", folder / "a"}, false).header.most == 10);
  part.header.spp = 65;
  write_checkpoint(folder / "b", part);
  CHECK_THROWS_WITH(merged({folder / "a", folder / "b"}, false), Contains("of 64 samples") && Contains("of 65"));
}

TEST_CASE("a part has as many samples in each sub-sum as its numbers say") {
  // Points 48 to 79 of both sequences; turns of 64.
  FilmSums film({FilmKind::pixels, 1, 1, {4, 2, 6}});
  film.first_sample = 96;
  film.samples = {64};
  CHECK(film.rows().sub_sum_weights(0) == SubSumWeights{16, 16, 16, 16});
  film.first_sample = 97;
  film.samples = {30};
  CHECK(film.rows().sub_sum_weights(0) == SubSumWeights{15, 15, 0, 0});
}

TEST_CASE("what pixels lack, as rectangles") {
  FilmSums film({FilmKind::pixels, 4, 5, {4, 2, 0}});
  film.first_sample = 10;
  film.samples = {2, 2, 2, 2,   //
                  2, 2, 2, 2,   //
                  2, 1, 1, 1,   //
                  1, 1, 1, 1,   //
                  8, 8, 8, 1};  //
  const std::vector<Launch> all = film.missing(1, 4, 18);
  std::vector<int> lacks(20, 0);
  for (const Launch& launch : all)
    for (int y = launch.row_first; y < launch.row_first + launch.rows; ++y)
      for (int x = launch.column_first; x < launch.column_first + launch.columns; ++x) {
        const auto at = static_cast<std::size_t>(4 * y + x);
        CHECK(launch.sample_first == 10 + film.samples[at]);
        lacks[at] += launch.samples;
      }
  for (std::size_t at = 0; at < 20; ++at) CHECK(lacks[at] == (at < 4 ? 0 : 8 - film.samples[at]));
  CHECK(all.size() == 5);
  CHECK(film.missing(0, 2, 12).empty());
  // Whole rows that are equally far are one launch.
  CHECK(film.missing(0, 2, 13).size() == 1);
}
