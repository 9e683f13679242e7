// SPDX-License-Identifier: MIT
// Names of the lane types and operations. LANED(x) is x_1, x_8 or x_16 by the value that LANES has where it is used,
// so a body written once over realw, intw and maskw exists at every width. Every macro ends in _w or is a type: bare
// names (any, select) would rewrite built-ins and standard headers for the rest of the unit.
#ifndef STRAHL_LANE_NAMES_H
#define STRAHL_LANE_NAMES_H

#define LANED_PASTE(name, lanes) name##_##lanes
#define LANED_EXPAND(name, lanes) LANED_PASTE(name, lanes)
#define LANED(name) LANED_EXPAND(name, LANES)

/// On kernels with wide bodies: tells runtimes that vectorise across work-items to leave them alone.
#define LANE_HINT_1
#define LANE_HINT_8 __attribute__((vec_type_hint(float8)))
#define LANE_HINT_16 __attribute__((vec_type_hint(float16)))
#define LANE_HINT LANED(LANE_HINT)

#define realw LANED(realw)
#define intw LANED(intw)
#define maskw LANED(maskw)

#define splat_w LANED(splat_w)
#define splat_int_w LANED(splat_int_w)
#define lt_w LANED(lt_w)
#define le_w LANED(le_w)
#define eq_w LANED(eq_w)
#define sel_w LANED(sel_w)
#define nonzero_w LANED(nonzero_w)
#define finite_w LANED(finite_w)
#define nan_w LANED(nan_w)
#define power_of_two_w LANED(power_of_two_w)
#define inverse_power_w LANED(inverse_power_w)
#define max_w LANED(max_w)
#define min_w LANED(min_w)
#define fma_w LANED(fma_w)
#define sqrt_w LANED(sqrt_w)
#define abs_w LANED(abs_w)
#define bits_w LANED(bits_w)
#define any_w LANED(any_w)
#define load_w LANED(load_w)
#define load_int_w LANED(load_int_w)
#define store_w LANED(store_w)

// lanes/double_word.h
#define dw_w LANED(dw_w)
#define sum3_w LANED(sum3_w)
#define dw3_w LANED(dw3_w)
#define two_sum_w LANED(two_sum_w)
#define quick_two_sum_w LANED(quick_two_sum_w)
#define two_prod_w LANED(two_prod_w)
#define dw_negate_w LANED(dw_negate_w)
#define dw_sel_w LANED(dw_sel_w)
#define dw_add_w LANED(dw_add_w)
#define dw_mul_w LANED(dw_mul_w)
#define dw_scale_w LANED(dw_scale_w)
#define dw_div_w LANED(dw_div_w)
#define dw_sqrt_w LANED(dw_sqrt_w)
#define sum3_begin_w LANED(sum3_begin_w)
#define sum3_add_w LANED(sum3_add_w)
#define sum3_round_w LANED(sum3_round_w)
#define two_difference3_w LANED(two_difference3_w)
#define dot_real3_w LANED(dot_real3_w)
#define real_dot_real3_w LANED(real_dot_real3_w)
#define difference_of_products_w LANED(difference_of_products_w)
#define dw_difference_of_products_w LANED(dw_difference_of_products_w)
#define cross_real3_w LANED(cross_real3_w)
#define dw_dot3_w LANED(dw_dot3_w)

#endif
