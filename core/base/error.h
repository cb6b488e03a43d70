// error.h: bad input, reported so that a user can act on it.
//
// Thrown for anything a user can cause; caught at the job boundary and in main. A bug is an assert,
// an expected absence an optional. Each part is plain text and may be empty, except `what`.
#pragma once
#include <stdexcept>
#include <string>

namespace neph {

/// The parts of an error message. docs/architecture.md, "Failures"
struct ErrorParts {
    std::string where{};     ///< file, preset or option with the fault
    std::string what{};      ///< what is wrong, naming the variable or key
    std::string found{};     ///< what was found
    std::string expected{};  ///< what was expected
    std::string hint{};      ///< the next step
};

/// The exception for bad input; what() is the complete message.
class Error : public std::runtime_error {
  public:
    explicit Error(ErrorParts parts);

    const ErrorParts& parts() const { return parts_; }

    /// The whole message as printed after "error: ", one to three lines, no trailing newline.
    std::string message() const { return what(); }

  private:
    ErrorParts parts_;
};

}  // namespace neph
