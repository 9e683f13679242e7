// SPDX-License-Identifier: MIT
// Files: magic, size of the header, header (JSON), samples, words, AOVs, checksum of all before it.
#include <fmt/format.h>
#include <sys/stat.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "checkpoint/checkpoint.h"
#include "image/atomic_file.h"
#include "image/file_bytes.h"
#include "json_text.h"
#include "packing/cl_layout.h"
#include "settings/sampling.h"
#include "settings/settings.h"

namespace strahl {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "numbers are stored as they are in memory");
constexpr std::string_view magic = "strahlK3";
constexpr std::size_t magic_family = 7;  ///< Of these letters all checkpoints begin with.
constexpr std::uint64_t most_header = std::uint64_t{1} << 28;
constexpr int most_side = 65536;  // As validate.h.

template <class T>
std::string_view bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

std::string json_of(const Checkpoint& checkpoint) {
  const CheckpointHeader& header = checkpoint.header;
  const FilmState& state = checkpoint.state;
  const FilmSums& film = state.film;
  const UploadFrame& frame = state.frame;
  Json identity = Json::array();
  for (const IdentityPart& part : header.identity.parts) identity.push_back({part.name, part.value, part.note});
  Json named_aovs = Json::array();
  for (const NamedAov& named : header.named_aovs) named_aovs.push_back(Json::array({named.name, aov_name(named.aov)}));
  const Json json = {
      {"identity", identity},
      {"metadata", header.metadata},
      {"aovs", header.aovs},
      {"named_aovs", named_aovs},
      {"is_length", header.is_length},
      {"spp", header.spp},
      {"least", header.least},
      {"most", header.most},
      {"film",
       {{"width", film.width},
        {"height", film.height},
        {"splats", film.kind == FilmKind::splats},
        {"sums", film.sums.count},
        {"sequences", film.sums.sequences},
        {"turn_bits", film.sums.turn_bits},
        {"first_sample", film.first_sample},
        {"unit", film.unit},
        {"squares", film.has_squares},
        {"own", film.has_own},
        {"weights", film.has_weights},
        {"noise_overlap", film.noise_overlap}}},
      {"has_aovs", !state.aov_reals.empty()},
      {"position",
       {{"done", state.position.done},
        {"check_at", state.position.check_at},
        {"max_error", state.position.max_error ? Json(*state.position.max_error) : Json()}}},
      {"unusual",
       {{"saturated", state.unusual.saturated},
        {"invalid", state.unusual.invalid},
        {"weak_branches", state.unusual.weak_branches},
        {"lost_branches", state.unusual.lost_branches},
        {"lost_interfaces", state.unusual.lost_interfaces}}},
      {"frame", {frame.origin.x, frame.origin.y, frame.origin.z, frame.scale}},
  };
  // Names of files need not be UTF-8.
  return json_text(json);
}

/// CRC-32 by zlib: of all before it, however it is divided.
class Checksum {
 public:
  void add(std::string_view bytes) {
    // Without data there may be no pointer, which zlib takes for the wish to begin anew.
    if (!bytes.empty()) sum_ = ::crc32_z(sum_, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  }
  [[nodiscard]] std::uint64_t value() const { return sum_; }

 private:
  uLong sum_ = ::crc32_z(0, nullptr, 0);
};

class Writer {
 public:
  explicit Writer(const std::string& path) : file_(path) {}
  void add(std::string_view bytes) {
    while (!bytes.empty()) {  // In pieces that are in the processor's cache from the sum to the writing.
      const std::string_view piece = bytes.substr(0, piece_bytes);
      sum_.add(piece);
      file_.write(piece.data(), piece.size());
      bytes.remove_prefix(piece.size());
    }
  }
  void add(std::uint64_t number) { add({reinterpret_cast<const char*>(&number), sizeof number}); }
  void finish() {
    const std::uint64_t sum = sum_.value();
    file_.write(&sum, sizeof sum);
    file_.commit_to_disk();
  }

 private:
  static constexpr std::size_t piece_bytes = std::size_t{1} << 18;
  AtomicFile file_;
  Checksum sum_;
};

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path), file_(nullptr, &std::fclose) {
    const std::string obstacle = unreadable_because(path);
    if (!obstacle.empty()) fail_to_read(obstacle);
    struct stat status {};
    // Before it is opened: for a pipe that would be to wait.
    if (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) fail_to_read("a checkpoint is a file");
    file_.reset(std::fopen(path.c_str(), "rb"));
    if (!file_ || ::fstat(::fileno(file_.get()), &status) != 0) fail_to_read(std::strerror(errno));
    size_ = static_cast<std::uint64_t>(status.st_size);
  }
  [[nodiscard]] std::uint64_t size() const { return size_; }

  template <class T>
  void take(T* values, std::size_t count) {
    if (std::fread(values, sizeof(T), count, file_.get()) != count)
      std::ferror(file_.get()) ? fail_to_read(std::strerror(errno)) : fail("ends too early");
    sum_.add({reinterpret_cast<const char*>(values), count * sizeof(T)});
  }
  template <class T>
  void take(std::vector<T>& values) {
    take(values.data(), values.size());
  }
  void require_checksum() {
    const std::uint64_t expected = sum_.value();
    std::uint64_t found = 0;
    take(&found, 1);
    if (found != expected) fail("its checksum is wrong");
  }
  [[noreturn]] void fail(const std::string& why) const {
    throw InputError(
        fmt::format("\"{}\" is damaged: {}; use another checkpoint, or render from the start", path_, why));
  }
  [[noreturn]] void fail_to_read(const std::string& why) const {
    throw InputError(fmt::format("cannot read \"{}\": {}", path_, why));
  }
  [[noreturn]] void fail_as_foreign(std::string_view begin) const {
    if (begin.substr(0, magic_family) == magic.substr(0, magic_family))
      throw InputError(
          fmt::format("\"{}\" is a checkpoint of another version of strahl: go on from it with that version, or "
                      "render from the start",
                      path_));
    throw InputError(fmt::format("\"{}\" is no checkpoint", path_));
  }

 private:
  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::uint64_t size_ = 0;
  Checksum sum_;
};

/// A number of the header within [least, most].
int number(const Json& json, int least, int most) {
  // Converting what has a fraction or 40 digits is undefined.
  if (!json.is_number_integer()) throw std::out_of_range("a number is no integer");
  const auto value = json.get<std::int64_t>();
  if (value < least || value > most) throw std::out_of_range("a number is out of range");
  return static_cast<int>(value);
}

std::uint64_t count(const Json& json) {
  if (!json.is_number_unsigned()) throw std::out_of_range("a count is none");
  return json.get<std::uint64_t>();
}

/// The film with its arrays' sizes, empty; header and arrays follow from it.
struct Head {
  CheckpointHeader header;
  FilmShape film;
  bool has_aovs;
  PassPosition position;
  UnusualSamples unusual;
  UploadFrame frame;

  [[nodiscard]] std::uint64_t pixels() const {
    return static_cast<std::uint64_t>(film.width) * static_cast<std::uint64_t>(film.height);
  }
  [[nodiscard]] std::uint64_t array_bytes() const {
    const std::uint64_t aovs = has_aovs ? layout::AOV_REALS * sizeof(double) + layout::AOV_INTS * sizeof(int) : 0;
    return pixels() * (sizeof(int) + film.words_per_pixel() * sizeof(std::int64_t) + aovs);
  }
};

Head head_of(const Json& json) {
  Head head;
  for (const Json& part : json.at("identity"))
    head.header.identity.parts.push_back(
        {part.at(0).get<std::string>(), part.at(1).get<std::string>(), part.at(2).get<std::string>()});
  head.header.metadata = json.at("metadata").get<std::map<std::string, std::string>>();
  head.header.aovs = json.at("aovs").get<std::vector<std::string>>();
  for (const Json& named : json.value("named_aovs", Json::array()))
    head.header.named_aovs.push_back({named.at(0).get<std::string>(), aov_from_name(named.at(1).get<std::string>())});
  head.header.is_length = json.at("is_length").get<bool>();
  head.header.spp = number(json.at("spp"), 0, max_spp);
  head.header.least = number(json.at("least"), 0, max_spp);
  head.header.most = number(json.at("most"), head.header.least, max_spp);
  const Json& film = json.at("film");
  FilmShape& shape = head.film;
  shape.kind = film.value("splats", false) ? FilmKind::splats : FilmKind::pixels;
  shape.width = number(film.at("width"), 1, most_side);
  shape.height = number(film.at("height"), 1, most_side);
  shape.sums.count = number(film.at("sums"), 1, layout::FILM_SUBSUMS);
  shape.sums.sequences = number(film.at("sequences"), 1, shape.sums.count);
  shape.sums.turn_bits = number(film.at("turn_bits"), 0, 20);
  if (!std::has_single_bit(static_cast<unsigned>(shape.sums.count)) ||
      !std::has_single_bit(static_cast<unsigned>(shape.sums.sequences)))
    throw std::out_of_range("a number of sums is no power of two");
  shape.first_sample = head.header.first_sample = number(film.at("first_sample"), 0, max_spp);
  shape.unit = film.at("unit").get<double>();
  shape.has_squares = film.value("squares", false);
  shape.has_own = film.value("own", false);
  shape.has_weights = film.at("weights").get<bool>();
  shape.noise_overlap = film.at("noise_overlap").get<double>();
  if (shape.has_own && shape.kind != FilmKind::splats) throw std::out_of_range("it has camera paths beside samples");
  if (shape.has_squares && shape.kind == FilmKind::splats) throw std::out_of_range("it has second moments of splats");
  if (shape.has_weights && shape.kind == FilmKind::splats) throw std::out_of_range("it has weights of splats");
  if (!(shape.noise_overlap >= 1)) throw std::out_of_range("its noise overlaps with less than itself");
  head.has_aovs = json.at("has_aovs").get<bool>();
  const auto has = [&](const NamedAov& named) {
    return is_of_first_sample(named.aov) ? head.has_aovs : named.aov == Aov::xyz || shape.has_squares;
  };
  const std::vector<NamedAov>& named_aovs = head.header.named_aovs;
  if (!(head.has_aovs || head.header.aovs.empty()) || !std::all_of(named_aovs.begin(), named_aovs.end(), has))
    throw std::out_of_range("it names AOVs and has none");
  const Json& position = json.at("position");
  head.position.done = number(position.at("done"), 0, max_spp);
  head.position.check_at = number(position.at("check_at"), 0, max_spp);
  if (const Json error = position.value("max_error", Json()); !error.is_null())
    head.position.max_error = error.get<double>();
  const Json& unusual = json.at("unusual");
  head.unusual = {count(unusual.at("saturated")), count(unusual.at("invalid")), count(unusual.at("weak_branches")),
                  count(unusual.value("lost_branches", Json(0))), count(unusual.at("lost_interfaces"))};
  const Json& frame = json.at("frame");
  head.frame = {{frame.at(0).get<double>(), frame.at(1).get<double>(), frame.at(2).get<double>()},
                frame.at(3).get<double>()};
  return head;
}

Head read_head(Reader& in) {
  char found[magic.size()] = {};
  std::uint64_t header_size = 0;
  if (in.size() < sizeof found) in.fail_as_foreign({});
  in.take(found, sizeof found);
  if (std::string_view(found, sizeof found) != magic) in.fail_as_foreign({found, sizeof found});
  in.take(&header_size, 1);
  const std::uint64_t fixed = sizeof found + 2 * sizeof(std::uint64_t);
  if (in.size() < fixed || header_size > std::min(most_header, in.size() - fixed)) in.fail("it is cut short");
  std::string text(header_size, 0);
  in.take(text.data(), text.size());
  std::optional<Head> head;
  try {
    head = head_of(Json::parse(text));
  } catch (const Json::exception& fault) {
    in.fail(fault.what());
  } catch (const std::out_of_range& fault) {
    in.fail(fault.what());
  } catch (const UsageError& fault) {  // The name of an AOV.
    in.fail(fault.what());
  }
  const std::uint64_t expected = fixed + header_size + head->array_bytes();
  if (in.size() != expected) in.fail(fmt::format("it has {} bytes and should have {}", in.size(), expected));
  return *head;
}

}  // namespace

void Checkpoint::told_of_film() {
  const auto [least, most] = std::minmax_element(state.film.samples.begin(), state.film.samples.end());
  header.least = *least;
  header.most = *most;
  header.first_sample = state.film.first_sample;
}

void write_checkpoint(const std::string& path, const Checkpoint& checkpoint) {
  Writer out(path);
  const std::string header = json_of(checkpoint);
  out.add(magic);
  out.add(header.size());
  out.add(header);
  out.add(bytes_of(checkpoint.state.film.samples));
  out.add(bytes_of(checkpoint.state.film.words));
  out.add(bytes_of(checkpoint.state.aov_reals));
  out.add(bytes_of(checkpoint.state.aov_ints));
  out.finish();
}

CheckpointHeader read_checkpoint_header(const std::string& path) {
  Reader in(path);
  return read_head(in).header;
}

Checkpoint read_checkpoint(const std::string& path) {
  Reader in(path);
  const Head head = read_head(in);
  Checkpoint checkpoint{head.header, {FilmSums(head.film), head.position, head.unusual, {}, {}, head.frame}};
  FilmState& state = checkpoint.state;
  if (head.has_aovs) {
    state.aov_reals.resize(head.pixels() * layout::AOV_REALS);
    state.aov_ints.resize(head.pixels() * layout::AOV_INTS);
  }
  in.take(state.film.samples);
  in.take(state.film.words);
  in.take(state.aov_reals);
  in.take(state.aov_ints);
  in.require_checksum();
  for (const int count : state.film.samples)
    if (count < head.header.least || count > head.header.most) in.fail("a pixel's number of samples is wrong");
  return checkpoint;
}

}  // namespace strahl
