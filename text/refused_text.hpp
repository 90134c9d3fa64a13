#pragma once

#include "text/diagnostic.hpp"
#include "text/user_error.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace placedpar {

/// Reports that a text was refused, with its diagnostics. what() is their rendered text.
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
