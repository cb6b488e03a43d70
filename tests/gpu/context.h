// context.h: the one GL context of the test program; made at first use and current ever after.
#pragma once
#include "app/gl/context.h"

namespace neph::test {

inline void needContext() {
    static const gl::HeadlessContext context;
}

}  // namespace neph::test
