#pragma once
// xxHash, compiled where it is used. It is told to read memory with memcpy: by itself (version 0.8.3) it
// reads doubles through pointers to integers, and GCC 14 may then digest a variable before it is written.

#define XXH_INLINE_ALL
#define XXH_FORCE_MEMORY_ACCESS 0
#include <xxhash.h>
