"""The edits that make a false text true, each of them proved by the engines that found it false."""
