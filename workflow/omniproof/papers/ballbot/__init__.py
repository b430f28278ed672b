"""Yi: kinematics of a ball driven by a platform with three Swedish wheels inside it."""
