// SPDX-License-Identifier: MIT
// Every way strahl can fail, and what a user is told about it.
//
// The library throws and never prints or exits; main.cpp is the only place that catches, prints and turns an
// exception into an exit code (see exit_code()).
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace strahl {

/// A place in an input file; line and column count from 1, 0 means unknown.
struct SourceLocation {
  std::string file;
  int line = 0;
  int column = 0;

  /// "scene.xml:12:7", shortened by what is unknown.
  [[nodiscard]] std::string text() const;
};

enum class Severity {
  note,  ///< Nothing is wrong; the user may want to know.
  warning,
  error
};

/// One problem of an input file.
struct Diagnostic {
  Severity severity = Severity::error;
  SourceLocation where;
  std::string message;  ///< One sentence, with the remedy where there is one.

  /// "scene.xml:12:7: error: unknown parameter ...".
  [[nodiscard]] std::string text() const;
};

/// Process exit codes, documented in `strahl --help`.
enum class ExitCode : int {
  ok = 0,
  failure = 1,
  usage = 2,
  input = 3,
  no_device = 4,
  kernel_build = 5,
  target_missed = 6,
  check_failed = 7,
  hung_up = 129,
  interrupted = 130,
  terminated = 143,
};

/// Base of everything that strahl throws.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message, ExitCode code = ExitCode::failure)
      : std::runtime_error(message), exit_code_(code) {}
  [[nodiscard]] ExitCode exit_code() const noexcept { return exit_code_; }

 private:
  ExitCode exit_code_;
};

/// The command line asks for something impossible.
class UsageError : public Error {
 public:
  explicit UsageError(const std::string& message) : Error(message, ExitCode::usage) {}
};

/// An input file (image, rays, mesh outside a scene) cannot be used.
class InputError : public Error {
 public:
  explicit InputError(const std::string& message) : Error(message, ExitCode::input) {}
};

/// A scene cannot be used; carries every problem found, errors and warnings in file order.
class SceneError : public Error {
 public:
  explicit SceneError(std::vector<Diagnostic> diagnostics);
  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const noexcept { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// No OpenCL device that can do what is asked for.
class NoDeviceError : public Error {
 public:
  explicit NoDeviceError(const std::string& message) : Error(message, ExitCode::no_device) {}
};

/// An OpenCL call failed. The message names call, symbolic code and device.
class DeviceError : public Error {
 public:
  DeviceError(const std::string& call, int code, const std::string& device, const std::string& detail = {});
  [[nodiscard]] int code() const noexcept { return code_; }

 protected:
  DeviceError(const std::string& message, int code, ExitCode exit_code) : Error(message, exit_code), code_(code) {}

 private:
  int code_;
};

/// A kernel does not build. The message adds options, build log and the path of the dumped source.
class KernelBuildError : public DeviceError {
 public:
  KernelBuildError(const std::string& message, int code) : DeviceError(message, code, ExitCode::kernel_build) {}
};

}  // namespace strahl
