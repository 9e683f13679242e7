// SPDX-License-Identifier: MIT
#include "selftest/faults.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace strahl::selftest {
namespace {

using Replacements = std::vector<std::pair<std::string, std::string>>;

struct Definition {
  FaultName fault;
  std::string option;
  Replacements replacements;  ///< Each, wherever it stands.
};

const std::vector<Definition>& definitions() {
  static const std::vector<Definition> all{
      {{"contraction", "a * b + c is contracted"},
       "",
       {{"#pragma OPENCL FP_CONTRACT OFF", "#pragma OPENCL FP_CONTRACT ON"}}},
      {{"relaxed-maths", "-cl-fast-relaxed-math, whatever the tier"}, "-cl-fast-relaxed-math", {}},
      {{"ftz", "denormal numbers count as zero"}, "-cl-denorms-are-zero", {}},
      {{"fastdiv", "quotients are an ulp off"}, "", {{" / ", " * R(1.0000001192092896) / "}}},
      {{"fastsqrt", "square roots are an ulp off"},
       "",
       {{"{ return sqrt(a); }", "{ return sqrt(a) * R(1.0000001192092896); }"}}},
      {{"nofma", "fma rounds its product"},
       "",
       {{"{ return fma(a, b, c); }", "{ return a * b + c; }"},
        {"{ return soft_fma(a, b, c); }", "{ return a * b + c; }"}}},
      {{"nofma-denormals", "fma returns zero below the normal numbers"},
       "",
       {{"{ return fma(a, b, c); }",
         "{ return fabs(fma(a, b, c)) < R(4.0) / REAL_MAX ? fma(a, b, c) - fma(a, b, c) : fma(a, b, c); }"},
        {"{ return soft_fma(a, b, c); }",
         "{ real r = soft_fma(a, b, c); return fabs(r) < R(4.0) / REAL_MAX ? r - r : r; }"}}},
      {{"nan-compare", "comparisons with NaN are true"},
       "",
       {{"{ return -(int)(a < b); }", "{ return -(int)!(a >= b); }"},
        {"{ return -(int)(a <= b); }", "{ return -(int)!(a > b); }"},
        {"{ return a < b; }", "{ return ~(a >= b); }"},
        {"{ return a <= b; }", "{ return ~(a > b); }"}}},
      {{"strict-edges", "edges belong to neither neighbour"},
       "",
       {{"return negative & positive;",
         "return (negative & positive) | eq_w(a, zero) | eq_w(b, zero) | eq_w(c, zero);"}}},
      {{"wrong-primitive", "hits are told of primitives that are not there"},
       "",
       {{"-1 : best.id;", "-1 : best.id + 100000;"}}},
      {{"forget-left", "the primitive just left is met again"},
       "",
       {{"if (ray->departed >= 0)", "if (ray->departed >= INT_MAX_ID)"}, {"if (id != excluded)", "if (id >= 0)"}}},
  };
  return all;
}

const Definition& definition(const std::string& name) {
  const auto& all = definitions();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Definition& d) { return d.fault.name == name; });
  if (found == all.end()) throw std::logic_error("there is no fault " + name);
  return *found;
}

int replace_all(std::string& text, const std::string& from, const std::string& to) {
  int count = 0;
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()), ++count)
    text.replace(at, from.size(), to);
  return count;
}

}  // namespace

const std::vector<FaultName>& fault_names() {
  static const std::vector<FaultName> names = [] {
    std::vector<FaultName> all;
    for (const Definition& known : definitions()) all.push_back(known.fault);
    return all;
  }();
  return names;
}

Fault::Fault(const std::string& name) : name_(name) {
  if (!name.empty()) static_cast<void>(definition(name));
}

void Fault::inject(ProgramSource& source) {
  if (name_.empty()) return;
  const Definition& fault = definition(name_);
  if (!fault.option.empty()) {
    source.options += " " + fault.option;
    ++injected_;
  }
  for (const auto& [from, to] : fault.replacements) injected_ += replace_all(source.text, from, to);
}

void Fault::require_injected() const {
  if (!name_.empty() && injected_ == 0) throw std::logic_error("no program has what the fault " + name_ + " changes");
}

}  // namespace strahl::selftest
