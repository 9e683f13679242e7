// SPDX-License-Identifier: MIT
// CIE 1931's X, Y and Z of linear sRGB: a row of the matrix each (IEC 61966-2-1:1999, in the digits of ITU-R BT.709
// that Mitsuba has). The host includes it as well (render/aov.cpp).
#ifndef STRAHL_FILM_XYZ_H
#define STRAHL_FILM_XYZ_H

#define XYZ_OF_RGB_X R(0.412453), R(0.357580), R(0.180423)
#define XYZ_OF_RGB_Y R(0.212671), R(0.715160), R(0.072169)
#define XYZ_OF_RGB_Z R(0.019334), R(0.119193), R(0.950227)

#endif
