// SPDX-License-Identifier: MIT
// What of media has no width. Only includes: a program without media holds none of it.
#include "media/media_rows.h"  // of homogeneous, heterogeneous
