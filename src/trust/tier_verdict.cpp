// SPDX-License-Identifier: MIT
#include "trust/tier_verdict.h"

namespace strahl {

const char* verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::degraded:
      return "degraded";
    case Verdict::refused:
      break;
  }
  return "refused";
}

}  // namespace strahl
