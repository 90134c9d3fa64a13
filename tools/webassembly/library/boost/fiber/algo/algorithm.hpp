#pragma once

#include <boost/fiber/context.hpp>
