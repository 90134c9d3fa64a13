#pragma once

// Random123 refuses processors that it was not tested on. WebAssembly has the byte order and the types of a 32-bit ARM.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <limits>
#include <stdexcept>

#define __arm__ 1
#include_next <Random123/philox.h>
#undef __arm__
