"""One subpackage a paper: what we derive and draw for it."""
