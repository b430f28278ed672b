"""The engine that decides claims; it knows no paper."""
