// hostile.h: declarations shared by the parts of the hostile reader.
#pragma once
#include <string>
#include <vector>

#include "core/plugin/reader_abi.h"

namespace hostile {

/// What a file asks for: `action` during `call`, one of the calls of the ABI.
struct Instruction {
    std::string call, action;

    std::string actionIn(const char* where) const;  ///< the action if `where` is its call, or empty
    void runIn(const char* where) const;            ///< performs the action if `where` is its call
};
Instruction readInstruction(const char* path);
Instruction loadInstruction();

/// A text without an end: it continues up to memory that is not mapped.
const char* unterminatedText();

/// A description that is valid except for one lie.
class FalseDescription {
  public:
    /// `callNumber` counts from 1.
    const NephDescription* describe(const std::string& lie, int callNumber);

  private:
    void setValid();
    void falsifyGrid(const std::string& lie, int callNumber);
    void falsifyLists(const std::string& lie);

    NephTime time_{};
    NephVariable variable_{}, heights_{};
    NephAttribute attribute_{};
    std::vector<const NephTime*> times_;
    std::vector<const NephVariable*> variables_;
    std::vector<const NephAttribute*> attributes_;
    std::vector<const char*> notes_;
    NephDescription description_{};
};

/// Reads the requested cells, except for one lie.
NephStatus read(const std::string& lie, NephReadRequest& request);

}  // namespace hostile
