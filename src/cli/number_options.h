// SPDX-License-Identifier: MIT
// Options whose value is a number: what counts as one is decided here for all of them. "nan" and "inf" are numbers to a
// C library, and compare as if they lay inside every range; "010" is 8 to it.
#pragma once

namespace CLI {
class Option;
}

namespace strahl::cli {

/// The option's value must be a finite number; returns the option.
CLI::Option* require_finite(CLI::Option* option);
/// The option's value must be a finite number greater than 0; returns the option.
CLI::Option* require_positive(CLI::Option* option);
/// The option's value must be a finite number from `least` to `most`; returns the option.
CLI::Option* require_between(CLI::Option* option, double least, double most);
/// Each of the option's values must be a whole number, read as decimal digits, and is then held against the other
/// checks; returns the option.
CLI::Option* require_whole(CLI::Option* option);

}  // namespace strahl::cli
