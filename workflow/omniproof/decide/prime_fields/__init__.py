"""A formula at random points of random prime fields: the engine without real numbers."""
