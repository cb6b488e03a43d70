// ensemble.h: several runs of one grid as one data set with members.
//
// The members agree in size and spacing of the columns and in their map; their levels may differ.
// Times are those of all members, matched by label, or by the time since the start of each run
// where no label is shared; a member may lack some. Opening reads headers only. What is asked of
// the ensemble as of any Dataset is answered by the first member that has the time.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/dataset/dataset.h"
#include "core/dataset/member_list.h"
#include "core/dataset/native_levels.h"

namespace neph {

/// In the place of a member's index: the mean of all.
inline constexpr int kMeanMember = -1;

/// Opens the files of one run, like Dataset::open.
using OpenRun = std::function<std::shared_ptr<Dataset>(std::span<const std::filesystem::path> paths,
                                                       const Progress& progress)>;

/// Runs of one grid.
class Ensemble : public Dataset {
  public:
    /// Throws Error if a member cannot be opened, its grid is not that of the first, or it shares
    /// no time with the others; or Cancelled.
    static std::shared_ptr<Ensemble> open(const MemberList& list, const OpenRun& openRun,
                                          const Progress& progress = {});

    int count() const { return static_cast<int>(members_.size()); }
    /// "mem03"; "mean" for kMeanMember.
    std::string nameOf(int member) const;
    /// The member of a name, or whose name ends with a number like no other does: "3" is mem03.
    /// kMeanMember for "mean". Throws Error that lists the names.
    int memberNamed(const std::string& name) const;
    /// As the member's own files state it; its times count by themselves.
    const DatasetInfo& infoOf(int member) const { return *of(member).info; }

    /// Index of a time of the ensemble among the member's own; none where it lacks the time.
    std::optional<int> timeIn(int member, int time) const;
    /// The members that have a time, at least one.
    std::vector<int> membersAt(int time) const;
    /// The error for a time that a member lacks.
    Error lacking(int member, int time) const;

    /// A member's run, for a handle of one's own.
    std::shared_ptr<const Dataset> runOf(int member) const { return of(member).run; }
    /// A member to read from. The few that were read last keep their files open; the reference is
    /// good until another is asked for.
    Dataset& run(int member);
    /// What was found of the heights at a time, by anyone with a handle of this ensemble.
    std::optional<NativeLevels> knownLevels(int time) const;
    void keepLevels(int time, const NativeLevels& levels);

    bool has(std::string_view variable, int time) const override;
    Array3f read(std::string_view variable, int time, std::optional<CellBox> box,
                 const Progress& progress) override;
    std::unique_ptr<Dataset> anotherHandle() const override;

  private:
    struct Member {
        std::string name;
        std::shared_ptr<Dataset> run;
        std::shared_ptr<const DatasetInfo> info;  ///< of the run, for any thread
        std::vector<int> times{};  ///< for each time of the ensemble the member's own; -1: none
    };
    struct Levels {
        std::mutex mutex;
        std::map<int, NativeLevels> found;  ///< by time
    };
    Ensemble() = default;
    const Member& of(int member) const { return members_.at(static_cast<std::size_t>(member)); }
    void matchTimes();
    void mergeInfo(const std::string& taken);
    void noteTimes();

    std::vector<Member> members_;
    std::vector<int> lastRead_;  // newest last
    std::shared_ptr<Levels> levels_ = std::make_shared<Levels>();
};

/// The data set as an ensemble; nullptr if it is a single run.
Ensemble* ensembleOf(Dataset& dataset);
const Ensemble* ensembleOf(const Dataset& dataset);

}  // namespace neph
