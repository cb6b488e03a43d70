// held_medium.h: the medium on the GPU, of which there is one at a time.
//
// Each engine has a kind of medium of its own; engines that read the same kind share it, so that
// going from one to the other bakes nothing. Another kind takes its place.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/look/medium.h"

namespace neph::render {

class HeldMedium {
  public:
    /// The medium of kind M that is held; where another kind is, an empty one takes its place.
    template <typename M>
    M& as() {
        if (auto* same = dynamic_cast<Of<M>*>(held_.get())) return same->medium;
        invalidate();
        held_.reset();  // before the new one takes memory
        auto made = std::make_unique<Of<M>>();
        M& medium = made->medium;
        held_ = std::move(made);
        return medium;
    }

    /// Has `bake(M&)` make the medium that `plan` asks for, unless it is held.
    template <typename M, typename Bake>
    void update(const MediumPlan& plan, const Bake& bake) {
        M& medium = as<M>();
        if (madeOf_ == plan) return;
        invalidate();
        bake(medium);
        madeOf_ = plan;
        ++version_;
    }

    /// What it was made of has changed: volume or shader.
    void invalidate() { madeOf_.reset(); }
    bool stale() const { return !madeOf_; }
    /// Differs from one medium to the next; never 0 where there is one.
    std::uint64_t version() const { return version_; }
    std::size_t bytes() const { return held_ ? held_->bytes() : 0; }

  private:
    struct Any {
        virtual ~Any() = default;
        virtual std::size_t bytes() const = 0;
    };
    template <typename M>
    struct Of final : Any {
        M medium;
        std::size_t bytes() const override { return medium.bytes(); }
    };

    std::unique_ptr<Any> held_;
    std::optional<MediumPlan> madeOf_;
    std::uint64_t version_ = 0;
};

}  // namespace neph::render
