// SPDX-License-Identifier: MIT
#include "trust/canary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "opencl/program.h"
#include "packing/scene_buffers.h"
#include "program/program_text.h"
#include "trust/canary_cases.h"
#include "trust/canary_loops.h"

namespace strahl {
namespace {

using P = CanaryProperty;

/// What a tier becomes where a property is missing. exact: robust and double.
struct Demand {
  const char* name;
  Verdict fast, stable, exact;
  const char* without;
};

constexpr Verdict holds = Verdict::holds, degraded = Verdict::degraded, refused = Verdict::refused;

/// In the order of CanaryProperty.
constexpr std::array demands{
    Demand{"finite arithmetic", refused, refused, refused, "sums, products, quotients or roots are far off"},
    Demand{"order", refused, refused, refused, "comparisons of numbers are wrong"},
    Demand{"conversions", refused, refused, refused, "conversions between integers and reals are wrong"},
    Demand{"NaN comparisons", holds, refused, refused, "comparisons with NaN are not false"},
    Demand{"infinities", holds, refused, refused, "overflow and division by zero are not what IEEE 754 says"},
    Demand{"sums", holds, refused, refused, "sums are not rounded correctly, or reordered"},
    Demand{"contraction off", holds, refused, refused, "a * b + c is contracted although that is switched off"},
    Demand{"products", holds, degraded, refused, "products or fma are not rounded correctly"},
    Demand{"division", holds, degraded, refused, "quotients are not rounded correctly"},
    Demand{"square root", holds, degraded, refused, "square roots are not rounded correctly"},
    Demand{"denormals", holds, degraded, refused, "numbers below the normal range count as zero"},
    Demand{"fma with denormals", holds, degraded, degraded, "fma is wrong near the denormal numbers"},
    Demand{"literal zeros", holds, holds, holds, ""},
    Demand{"fmin, fmax of NaN", holds, holds, holds, ""},
    Demand{"long loops", degraded, degraded, degraded, "ends loops"},
};

Verdict demanded(const Demand& demand, Precision precision) {
  switch (precision) {
    case Precision::fast:
      return demand.fast;
    case Precision::stable:
      return demand.stable;
    case Precision::robust:
    case Precision::fp64:
      return demand.exact;
  }
  return demand.exact;
}

/// Signs of zeros are no result that anything builds on: the dialect compares.
template <typename Real>
bool is_right(P property, Real got, Real expected) {
  if (std::isnan(expected)) return std::isnan(got);
  if (property == P::infinities && std::fpclassify(expected) == FP_SUBNORMAL) return true;
  if (property == P::finite_arithmetic) return std::fabs(got - expected) <= Real(0x1p-20) * std::fabs(expected);
  if (property == P::literal_zeros) return got == expected && std::signbit(got) == std::signbit(expected);
  return got == expected;
}

template <typename Real>
struct Judged {
  CanaryFinding finding;
  Real largest_wrong = 0;  ///< Of the results that were expected.
};

/// got: planes of results over all cases; first: the group's first case.
template <typename Real>
void judge(const CanaryGroup<Real>& group, const std::vector<Real>& got, std::size_t planes, std::size_t first,
           Judged<Real>& judged) {
  static constexpr std::array operations{"a + b",          "error of a + b", "a - b",         "a * b",
                                         "error of a * b", "a * b + c",      "a * b - c * d", "a * b - c * d by Kahan",
                                         "a / b",          "sqrt(a)",        "fma(a, b, c)",  "larger",
                                         "smaller",        "order",          "truncated",     "from uint",
                                         "a * 0",          "a + 0",          "fmin(a, b)",    "fmax(a, b)"};
  static_assert(operations.size() == layout::CANARY_OUTPUTS);
  for (std::size_t i = 0; i < group.cases.size(); ++i)
    for (const int output : group.outputs) {
      const auto [a, b, c, d] = group.cases[i];
      const Real expected = canary_expected(output, group.cases[i]);
      const Real result = got[static_cast<std::size_t>(output) * planes + first + i];
      ++judged.finding.cases;
      if (is_right(group.property, result, expected)) continue;
      if (judged.finding.wrong++ == 0)
        judged.finding.detail = fmt::format("{} is {:a}, not {:a}, of {:a}, {:a}, {:a}, {:a}",
                                            operations[static_cast<std::size_t>(output)], result, expected, a, b, c, d);
      judged.largest_wrong = std::max(judged.largest_wrong, std::fabs(expected));
    }
}

/// Up to which size of a product its error term is lost, where fma loses results up to that size: the error of a
/// product of two numbers of p bits is a multiple of 2^(1 - 2 p) of it.
template <typename Real>
std::string scale_of(Real largest_wrong) {
  const int p = std::numeric_limits<Real>::digits, exponent = std::ilogb(largest_wrong) + 1;
  return fmt::format("; holds for products above 2^{}, lengths above 2^{}", exponent + 2 * p - 1,
                     (exponent + 2 * p) / 2);
}

template <typename Real>
void probe(const Device& device, const cl::Program& program, int lanes, const std::vector<CanaryGroup<Real>>& groups,
           std::vector<Judged<Real>>& judged) {
  std::vector<CanaryCase<Real>> cases;
  for (const auto& group : groups) cases.insert(cases.end(), group.cases.begin(), group.cases.end());
  cases.resize((cases.size() + 15) / 16 * 16, {1, 1, 1, 1});
  const std::size_t count = cases.size();
  std::vector<Real> in(layout::CANARY_INPUTS * count), out(layout::CANARY_OUTPUTS * count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t plane = 0; plane < layout::CANARY_INPUTS; ++plane) in[plane * count + i] = cases[i][plane];

  const cl::Buffer in_buffer = allocate(device, in.size() * sizeof(Real), "the canary");
  const cl::Buffer out_buffer = allocate(device, out.size() * sizeof(Real), "the canary");
  write_buffer(device, in_buffer, in.data(), in.size() * sizeof(Real));
  checked(device.info().text(), [&] {
    cl::Kernel kernel(program, fmt::format("canary_w_{}", lanes).c_str());
    kernel.setArg(0, in_buffer);
    kernel.setArg(1, out_buffer);
    kernel.setArg(2, static_cast<cl_int>(count));
    device.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(count / static_cast<std::size_t>(lanes)));
    device.queue().finish();
  });
  read_buffer(device, out_buffer, out.data(), out.size() * sizeof(Real));

  std::size_t first = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    judge(groups[g], out, count, first, judged[g]);
    first += groups[g].cases.size();
  }
}

CanaryFinding finding_of(const LoopTurns& loops) {
  CanaryFinding finding;
  finding.cases = static_cast<int>(loop_cases.size());
  for (std::size_t i = 0; i < loop_cases.size(); ++i) {
    const auto [outer, inner] = loop_cases[i];
    if (loops.made[i] == loop_cases[i].turns() || finding.wrong++ > 0) continue;
    finding.detail = fmt::format("{} times a loop of {} turns ends after {} turns", outer, inner, loops.made[i]);
  }
  return finding;
}

template <typename Real>
CanaryReport run_as(const Device& device, Precision precision, const CanaryOptions& options) {
  const std::vector<CanaryGroup<Real>> groups = canary_groups<Real>();
  std::vector<Judged<Real>> judged(groups.size());
  const int widest = options.lanes.value_or(default_lanes(device.info().native_vector_width, precision));
  // The arithmetic alone: nothing of a scene.
  const auto built = [&](bool ends_loops) {
    ProgramSource source = program_source("kernels/canary.cl", no_features(ends_loops), precision, widest);
    if (options.lanes) source.text.insert(0, "#define CANARY_ONE_LANE 0\n");
    if (options.change) options.change(source);
    return build_program(device, source);
  };
  const cl::Program program = built(false);
  if (!options.lanes && widest != 1) probe(device, program, 1, groups, judged);
  probe(device, program, widest, groups, judged);
  const LoopTurns loops = turns_made(device, program);
  // Programs for such a device have functions that are called where others have them inlined: another compiler's work.
  if (loops.limit()) probe(device, built(true), widest, groups, judged);

  CanaryReport report{{precision, holds, {}, {}}, {}};
  const auto take = [&](P property, CanaryFinding finding, const std::string& detail) {
    const Demand& demand = demands[static_cast<std::size_t>(property)];
    finding.property = demand.name;
    if (finding.wrong > 0) {
      finding.verdict = demanded(demand, precision);
      if (finding.verdict > holds) report.tier.why += (report.tier.why.empty() ? "" : "; ") + (demand.without + detail);
      report.tier.verdict = std::max(report.tier.verdict, finding.verdict);
    }
    report.findings.push_back(std::move(finding));
  };
  for (std::size_t g = 0; g < groups.size(); ++g)
    take(groups[g].property, judged[g].finding,
         groups[g].property == P::fma_denormals ? scale_of(judged[g].largest_wrong) : "");
  report.tier.loop_turns = loops.limit();
  take(P::long_loops, finding_of(loops),
       report.tier.loop_turns ? fmt::format(" after {} turns", *report.tier.loop_turns) : "");
  if (!loops.can_be_told()) {
    report.tier.verdict = report.findings.back().verdict = refused;
    report.tier.why += ", and which have come to their end cannot be told";
  }
  return report;
}

}  // namespace

CanaryReport run_canary(const Device& device, Precision precision, const CanaryOptions& options) {
  if (precision != Precision::fp64) return run_as<float>(device, precision, options);
  if (!device.info().fp64) return {{precision, refused, "the device has no double precision", {}}, {}};
  return run_as<double>(device, precision, options);
}

}  // namespace strahl
