#pragma once

#include "text/diagnostic.hpp"
#include "text/user_error.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace placedpar {

/// Reports that a user's text was refused. Has the diagnostics as objects; what() is the text of render(diagnostics).
class RefusedText : public RefusedInput {
public:
    explicit RefusedText(std::vector<Diagnostic> diagnostics)
        : RefusedInput(render(diagnostics)),
          diagnostics_(std::make_shared<const std::vector<Diagnostic>>(std::move(diagnostics))) {}

    const std::vector<Diagnostic>& diagnostics() const { return *diagnostics_; }

private:
    std::shared_ptr<const std::vector<Diagnostic>> diagnostics_; ///< shared, since copying an exception must not fail
};

} // namespace placedpar
