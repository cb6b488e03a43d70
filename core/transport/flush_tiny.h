// flush_tiny.h: arithmetic without subnormal numbers, which take a hundred times as long.
#pragma once
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace neph {

/// While it lives this thread takes results below 1e-38 for 0, where the processor can: what is
/// left of light behind much cloud.
class FlushTiny {
  public:
#ifdef __SSE2__
    FlushTiny() : before_(_mm_getcsr()) {
        _mm_setcsr(before_ | kFlushToZero | kTakeForZero);
    }
    ~FlushTiny() {
        _mm_setcsr(before_);
    }
#else
    FlushTiny() = default;
#endif
    FlushTiny(const FlushTiny&) = delete;
    FlushTiny& operator=(const FlushTiny&) = delete;

#ifdef __SSE2__
  private:
    static constexpr unsigned kFlushToZero = 0x8000U, kTakeForZero = 0x40U;
    unsigned before_;
#endif
};

}  // namespace neph
