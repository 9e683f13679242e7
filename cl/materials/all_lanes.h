// SPDX-License-Identifier: MIT
// Every material, after what several of them share. Only includes: a program holds the materials that its scene uses,
// and what is "of" some of them, or "not of" some, where it has one of those, or another one.
#include "math/atan2_lanes.h"          // of roughdiffuse
#include "math/metal_fresnel_lanes.h"  // of conductor, roughconductor
#include "materials/microfacets_lanes.h"  // of roughconductor, roughdielectric, roughplastic, principled, principledthin, ward
#include "materials/base_lanes.h"         // of plastic, roughplastic
#include "materials/disney_lanes.h"  // of principled, principledthin
#include "materials/diffuse_lanes.h"
#include "materials/conductor_lanes.h"
#include "materials/dielectric_lanes.h"
#include "materials/roughconductor_lanes.h"
#include "materials/roughdielectric_lanes.h"
#include "materials/thindielectric_lanes.h"
#include "materials/plastic_lanes.h"
#include "materials/roughplastic_lanes.h"
#include "materials/principled_lanes.h"
#include "materials/principledthin_lanes.h"
#include "materials/phong_lanes.h"
#include "materials/roughdiffuse_lanes.h"
#include "materials/difftrans_lanes.h"
#include "materials/ward_lanes.h"
