// hostile.h: what the parts of the hostile reader share.
#pragma once
#include <string>
#include <vector>

#include "core/plugin/reader_abi.h"

namespace hostile {

struct Words {
    std::string stage, deed;

    std::string lieAt(const char* where) const;  ///< the deed, where this is its stage
    void actAt(const char* where) const;         ///< does the deed, where this is its stage
};
Words wordsOf(const char* path);
Words loadWords();

/// A text that runs up to memory that is not there.
const char* endlessText();

/// The description of one file, right but for one lie.
class Lies {
  public:
    /// `call` counts from 1.
    const NephDescription* describe(const std::string& lie, int call);

  private:
    void tellTruth();
    void spoilGrid(const std::string& lie, int call);
    void spoilLists(const std::string& lie);

    NephTime time_{};
    NephVariable variable_{}, heights_{};
    NephAttribute attribute_{};
    std::vector<const NephTime*> times_;
    std::vector<const NephVariable*> variables_;
    std::vector<const NephAttribute*> attributes_;
    std::vector<const char*> notes_;
    NephDescription description_{};
};

/// Gives the cells asked for, or breaks one promise.
NephStatus read(const std::string& lie, NephReadRequest& request);

}  // namespace hostile
