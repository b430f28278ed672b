"""Kimura, Nakayama, Suzuki, Ishii (2025): trajectories of a robot on three omni rollers."""
