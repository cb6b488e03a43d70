// sanitized.h: sanitizers make solutions of light many times slower; their builds try fewer.
#pragma once

#ifdef NEPH_SANITIZED
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
