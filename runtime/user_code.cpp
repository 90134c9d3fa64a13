#include "runtime/user_code.hpp"

#include "runtime/kernel.hpp"
#include "runtime/replay_log.hpp"

#include <exception>

namespace placedpar {

std::string what_was_thrown() {
    try {
        throw;
    } catch (const Unwinding&) {
        throw;
    } catch (const ReplayDivergence&) {
        throw;
    } catch (const std::exception& thrown) {
        return thrown.what();
    } catch (const char* text) {
        return text ? text : "a null pointer";
    } catch (...) {
        return "an exception that is not a std::exception";
    }
}

} // namespace placedpar
