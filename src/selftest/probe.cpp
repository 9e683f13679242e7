// SPDX-License-Identifier: MIT
#include "selftest/probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include "opencl/program.h"
#include "packing/cl_layout.h"
#include "packing/pack_shapes.h"
#include "packing/scene_buffers.h"
#include "program/program_text.h"
#include "stopwatch.h"

namespace strahl::selftest {
namespace {

constexpr std::size_t largest_group = 64;

/// Reals of geometry a launch (a question larger than that has a launch of its own), so that buffers stay small.
constexpr std::size_t launch_reals = std::size_t{1} << 22;

Features only(const std::string& kind, bool ends_loops) {
  Features features = no_features(ends_loops);
  features.entries["shapes"].insert(kind);
  return features;
}

/// One launch's questions as the kernel reads them.
template <typename Real>
struct Packed {
  std::vector<Real> blocks, rays;
  std::vector<std::int32_t> ids, first, left;

  void clear() {
    blocks.clear();
    rays.clear();
    ids.clear();
    first.assign(1, 0);
    left.clear();
  }

  /// About the question's primitives from `begin` on, as many as `primitives`.
  void add(const Question& question, std::size_t planes, std::size_t lanes, std::size_t begin, std::size_t primitives) {
    const std::size_t block_count = (primitives + lanes - 1) / lanes;
    const std::size_t reals_at = blocks.size(), ids_at = ids.size();
    blocks.resize(reals_at + block_count * lanes * planes, Real(0));
    ids.resize(ids_at + block_count * lanes, -1);
    const double* value = question.planes.data() + begin * planes;
    for (std::size_t i = 0; i < primitives; ++i) {
      Real* lane = &blocks[reals_at + i / lanes * lanes * planes + i % lanes];
      for (std::size_t plane = 0; plane < planes; ++plane) lane[plane * lanes] = static_cast<Real>(*value++);
      ids[ids_at + i] = static_cast<std::int32_t>(begin + i);
    }
    first.push_back(static_cast<std::int32_t>(ids.size() / lanes));
    left.push_back(question.left);
    const oracle::Ray& ray = question.ray;
    for (const double x : {ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z,
                           ray.t_min, ray.t_max})
      rays.push_back(static_cast<Real>(x));
  }
};

/// A buffer that grows to what is asked of it.
class Buffer {
 public:
  explicit Buffer(const Device& device) : device_(device) {}

  const cl::Buffer& of(std::size_t bytes) {
    if (bytes > bytes_) {
      buffer_ = allocate(device_, bytes, "a batch of questions");
      bytes_ = bytes;
    }
    return buffer_;
  }
  template <typename T>
  const cl::Buffer& holding(const std::vector<T>& values) {
    of(values.size() * sizeof(T));
    if (!values.empty()) write_buffer(device_, buffer_, values.data(), values.size() * sizeof(T));
    return buffer_;
  }

 private:
  const Device& device_;
  cl::Buffer buffer_;
  std::size_t bytes_ = 0;
};

}  // namespace

struct Probe::State {
  Device device;
  std::string kind;
  Precision precision;
  std::size_t lanes;
  std::size_t planes;
  cl::Kernel kernel;
  std::size_t group;
  Buffer blocks{device}, ids{device}, first{device}, rays{device}, left{device}, t{device}, primitive{device};
  double nanoseconds = 0, tests = 0;

  template <typename Real>
  void ask(std::span<const Question> questions, std::vector<Answer>& answers);
  template <typename Real>
  Answer alone(const Question& question, std::size_t begin, std::size_t count);
  template <typename Real>
  void launch(const Packed<Real>& packed, std::vector<Answer>& answers);
};

template <typename Real>
void Probe::State::launch(const Packed<Real>& packed, std::vector<Answer>& answers) {
  const std::size_t count = packed.left.size();
  std::vector<Real> ts(count);
  std::vector<std::int32_t> primitives(count);
  const std::array<const cl::Buffer*, 7> arguments{&blocks.holding(packed.blocks),
                                                   &ids.holding(packed.ids),
                                                   &first.holding(packed.first),
                                                   &rays.holding(packed.rays),
                                                   &left.holding(packed.left),
                                                   &t.of(count * sizeof(Real)),
                                                   &primitive.of(count * sizeof(std::int32_t))};
  checked(device.info().text(), [&] {
    cl_uint arg = 0;
    for (const cl::Buffer* buffer : arguments) kernel.setArg(arg++, *buffer);
    kernel.setArg(arg, static_cast<cl_int>(count));
    const std::size_t padded = (count + group - 1) / group * group;
    cl::Event event;
    const Stopwatch watch;
    device.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(padded), cl::NDRange(group), nullptr,
                                        &event);
    event.wait();
    const auto measured =
        event.getProfilingInfo<CL_PROFILING_COMMAND_END>() - event.getProfilingInfo<CL_PROFILING_COMMAND_START>();
    // Some drivers (Mesa 22) time only the submission.
    const double waited = 1e9 * watch.seconds(), ran = static_cast<double>(measured);
    nanoseconds += ran > 0.01 * waited ? ran : waited;
  });
  tests += static_cast<double>(packed.ids.size());
  read_buffer(device, *arguments[5], ts.data(), count * sizeof(Real));
  read_buffer(device, *arguments[6], primitives.data(), count * sizeof(std::int32_t));
  for (std::size_t i = 0; i < count; ++i) answers.push_back({static_cast<double>(ts[i]), primitives[i]});
}

template <typename Real>
void Probe::State::ask(std::span<const Question> questions, std::vector<Answer>& answers) {
  Packed<Real> packed;
  packed.clear();
  for (const Question& question : questions) {
    if (question.kind != kind)
      throw std::logic_error(fmt::format("a probe of {} is asked about {}", kind, question.kind));
    packed.add(question, planes, lanes, 0, question.planes.size() / planes);
    if (packed.blocks.size() < launch_reals) continue;
    launch(packed, answers);
    packed.clear();
  }
  if (!packed.left.empty()) launch(packed, answers);
  for (std::size_t i = 0; i < questions.size(); ++i)
    if (answers[i].primitive == layout::FOUND_CUT)
      answers[i] = alone<Real>(questions[i], 0, questions[i].planes.size() / planes);
}

/// The nearest one of some primitives, in halves where the device ends the loops of all of them.
template <typename Real>
Answer Probe::State::alone(const Question& question, std::size_t begin, std::size_t count) {
  Packed<Real> packed;
  packed.clear();
  packed.add(question, planes, lanes, begin, count);
  std::vector<Answer> answers;
  launch(packed, answers);
  constexpr Answer no_answer{std::numeric_limits<double>::quiet_NaN(), layout::FOUND_CUT};
  if (answers.front().primitive != layout::FOUND_CUT) return answers.front();
  if (count <= lanes) return no_answer;
  const Answer lower = alone<Real>(question, begin, count / 2);
  const Answer upper = alone<Real>(question, begin + count / 2, count - count / 2);
  if (lower.primitive == layout::FOUND_CUT || upper.primitive == layout::FOUND_CUT) return no_answer;
  return upper.t < lower.t ? upper : lower;
}

Probe::Probe(const Device& device, const std::string& kind, Precision precision, const ProbeOptions& options) {
  const int lanes = options.lanes.value_or(default_lanes(device.info().native_vector_width, precision));
  ProgramSource source = program_source("kernels/probe.cl", only(kind, options.ends_loops), precision, lanes);
  if (options.change) options.change(source);
  const cl::Program program = program_on(device, source);
  const cl::Kernel kernel = checked(device.info().text(), [&] { return cl::Kernel(program, "probe"); });
  state_ = std::unique_ptr<State>(new State{device, kind, precision, static_cast<std::size_t>(lanes),
                                            static_cast<std::size_t>(planes_of(kind)), kernel,
                                            group_size(device, kernel, largest_group)});
}
Probe::~Probe() = default;
Probe::Probe(Probe&&) noexcept = default;
Probe& Probe::operator=(Probe&&) noexcept = default;

std::vector<Answer> Probe::ask(std::span<const Question> questions) {
  std::vector<Answer> answers;
  answers.reserve(questions.size());
  if (state_->precision == Precision::fp64)
    state_->ask<double>(questions, answers);
  else
    state_->ask<float>(questions, answers);
  return answers;
}

int Probe::lanes() const { return static_cast<int>(state_->lanes); }

double Probe::nanoseconds_per_test() const { return state_->tests > 0 ? state_->nanoseconds / state_->tests : 0; }

}  // namespace strahl::selftest
