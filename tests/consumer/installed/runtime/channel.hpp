#pragma once

/// A header of the consumer's own that has the name of one of ours.
struct Channel {
    int number;
};
