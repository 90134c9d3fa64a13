#pragma once

/// The consumer has a header of its own with the same name as one of PlacedPar's.
struct Channel {
    int number;
};
