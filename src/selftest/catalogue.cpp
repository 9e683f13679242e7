// SPDX-License-Identifier: MIT
// The language of the rows stands at the head of rows/sphere.txt.
#include "selftest/catalogue.h"

#include <fmt/format.h>

#include <algorithm>

#include "errors.h"
#include "packing/pack_shapes.h"
#include "selftest/embedded_rows.h"
#include "selftest/generators.h"
#include "selftest/row_reader.h"

namespace strahl::selftest {
namespace {

/// In this order; files of other names follow, in that of their names.
constexpr const char* first_families[] = {"sphere", "plane",     "checkerboard", "triangle", "box",
                                          "camera", "rectangle", "disk",         "cylinder"};

std::size_t rank_of(const EmbeddedRows& file) {
  const auto* end = std::end(first_families);
  const auto is_it = [&](const std::string& family) { return file.name == family + ".txt"; };
  return static_cast<std::size_t>(std::find_if(std::begin(first_families), end, is_it) - std::begin(first_families));
}

constexpr const char* shape_kinds[] = {
#define SHAPE(name, planes) #name,
#include "../../cl/shapes/shapes.def"
#undef SHAPE
};

bool is_shape(const std::string& word) {
  return std::find(std::begin(shape_kinds), std::end(shape_kinds), word) != std::end(shape_kinds);
}

class RowsReader {
 public:
  RowsReader(std::string family, const std::string& text) : family_(std::move(family)), text_(text) {}

  std::vector<Row> read() {
    while (next_line()) {
      if (line_.empty() || line_[0] == '#') continue;
      if (line_[0] == '[') {
        begin_row();
      } else {
        if (rows_.empty()) here().fail("a row begins with [id] title");
        read_statement();
      }
    }
    for (const Row& row : rows_) check(row);
    return std::move(rows_);
  }

 private:
  bool next_line() {
    if (position_ >= text_.size()) return false;
    const std::size_t end = std::min(text_.find('\n', position_), text_.size());
    line_ = text_.substr(position_, end - position_);
    position_ = end + 1;
    ++number_;
    return true;
  }

  [[nodiscard]] RowLine here() const { return {family_ + ".txt", number_, line_}; }

  void begin_row() {
    const std::size_t close = line_.find("] ");
    if (close == std::string::npos) here().fail("a row begins with [id] title");
    Row row;
    row.id = line_.substr(1, close - 1);
    row.title = line_.substr(close + 2);
    row.family = family_;
    row.line = number_;
    rows_.push_back(row);
    kind_.clear();
  }

  void read_statement() {
    RowLine line = here();
    if (line.is_empty()) return;
    Row& row = rows_.back();
    const std::string word = line.word();
    if (word == "source:") {
      row.source = line.rest();
    } else if (word == "once") {
      row.is_once = true;
      line.end();
    } else if (is_shape(word)) {
      read_shape(word, line);
    } else if (word == "ray") {
      read_ray(row, line);
    } else if (word == "generate") {
      read_generator(row, line);
    } else if (word == "accept" || word == "refuse") {
      const std::string refusal = word == "refuse" ? line.rest() : "";
      line.end();
      row.rules.push_back({scene_text(), refusal});
    } else if (word == "picture") {
      const std::string check = line.word();
      line.end();
      row.pictures.push_back({scene_text(), check});
    } else if (word == "held") {
      if (!line.take("by:")) line.fail("say \"held by: folder/test_name.cpp\"");
      row.held_by.push_back(line.word());
    } else {
      line.fail(fmt::format("unknown word \"{}\"", word));
    }
  }

  /// Shapes gather until a ray asks about them; the next one after a ray begins anew.
  void read_shape(const std::string& kind, RowLine& line) {
    if (is_asked_ || kind_.empty()) planes_.clear(), kind_ = kind, is_asked_ = false;
    if (kind_ != kind) line.fail("the shapes of a question are of one kind");
    const std::vector<double> planes = line.reals(planes_of(kind));
    line.end();
    planes_.insert(planes_.end(), planes.begin(), planes.end());
  }

  void read_ray(Row& row, RowLine& line) {
    if (kind_.empty()) line.fail("a ray needs a shape before it");
    is_asked_ = true;
    Question q;
    q.kind = kind_;
    q.planes = planes_;
    const std::vector<double> r = line.reals(6);
    q.ray.origin = {r[0], r[1], r[2]};
    q.ray.direction = {r[3], r[4], r[5]};
    if (line.take("from")) q.ray.t_min = line.real();
    if (line.take("to")) q.ray.t_max = line.real();
    if (line.take("left")) q.left = line.integer();
    const int count = static_cast<int>(planes_.size()) / planes_of(kind_);
    if (q.left >= count) line.fail("that shape is not there to be left");
    if (!line.take("->")) line.fail("an answer is needed: -> miss, -> either or -> hit");
    read_answer(q, line);
    line.end();
    if (q.primitive >= count) line.fail("that shape is not there to be hit");
    row.frozen.push_back(q);
  }

  static void read_answer(Question& q, RowLine& line) {
    if (line.take("miss")) {
      q.expected = Expected::miss;
    } else if (line.take("either")) {
      q.expected = Expected::either;
    } else if (line.take("hit")) {
      q.expected = Expected::hit;
      if (!line.take("any")) q.primitive = line.integer();
      if (!line.take("t")) line.fail("a hit has a t");
      q.t.value = line.wide_real();
      q.t.rest = line.wide_real();
      if (line.take("within")) q.t_rounding = line.wide_real();
    } else {
      line.fail("an answer is miss, either or hit");
    }
  }

  static void read_generator(Row& row, RowLine& line) {
    Generated g;
    g.generator = line.word();
    if (!line.take("seed")) line.fail("a generator has a seed");
    g.seed = static_cast<std::uint64_t>(line.integer());
    if (!line.take("count")) line.fail("a generator has a count");
    g.count = line.integer();
    while (!line.is_empty()) {
      const std::string name = line.word();
      g.sizes[name] = line.real();
    }
    if (!is_generator(g.generator)) line.fail(fmt::format("there is no generator \"{}\"", g.generator));
    row.generated.push_back(g);
  }

  /// The indented lines that follow; a body alone gets a scene and a sensor around it.
  std::string scene_text() {
    std::string body;
    while (position_ < text_.size() && text_.compare(position_, 2, "  ") == 0 && next_line()) body += line_ + "\n";
    if (body.empty()) here().fail("the scene is missing: indented lines below");
    const bool has_sensor = body.find("<sensor") != std::string::npos;
    return "<scene version=\"3.0.0\">\n" + body + (has_sensor ? "" : "<sensor type=\"perspective\"/>\n") + "</scene>\n";
  }

  void check(const Row& row) const {
    const auto fail = [&](const std::string& message) {
      throw InputError(fmt::format("{}.txt:{}: [{}] {}", family_, row.line, row.id, message));
    };
    if (row.source.empty()) fail("names no source");
    if (row.frozen.size() > 100) fail("has more than 100 frozen cases; make it a generator");
    if (contents(row).empty()) fail("asks nothing");
  }

  const std::string family_, text_;
  std::size_t position_ = 0;
  int number_ = 0;
  std::string line_;
  std::vector<Row> rows_;
  std::string kind_;
  std::vector<double> planes_;
  bool is_asked_ = false;
};

}  // namespace

std::vector<Row> parse_rows(const std::string& family, const std::string& text) {
  return RowsReader(family, text).read();
}

const std::vector<Row>& catalogue() {
  static const std::vector<Row> rows = [] {
    std::vector<Row> all;
    std::vector<EmbeddedRows> files(embedded_rows().begin(), embedded_rows().end());
    std::stable_sort(files.begin(), files.end(),
                     [](const EmbeddedRows& a, const EmbeddedRows& b) { return rank_of(a) < rank_of(b); });
    for (const EmbeddedRows& file : files) {
      const std::string family(file.name.substr(0, file.name.find('.')));
      for (Row& row : parse_rows(family, std::string(file.text))) all.push_back(std::move(row));
    }
    return all;
  }();
  return rows;
}

std::vector<Question> questions_of(const Row& row, int most) {
  std::vector<Question> questions = row.frozen;
  for (Generated call : row.generated) {
    call.count = std::min(call.count, most);
    for (Question& q : generate(call)) questions.push_back(std::move(q));
  }
  return questions;
}

std::string contents(const Row& row) {
  std::vector<std::string> parts;
  if (!row.frozen.empty()) parts.push_back(fmt::format("{} frozen", row.frozen.size()));
  int generated = 0;
  for (const Generated& call : row.generated) generated += call.count;
  if (generated > 0) parts.push_back(fmt::format("{} generated", generated));
  if (!row.rules.empty()) parts.emplace_back("loader");
  if (!row.pictures.empty()) parts.emplace_back("picture");
  if (!row.held_by.empty()) parts.emplace_back("test");
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace strahl::selftest
