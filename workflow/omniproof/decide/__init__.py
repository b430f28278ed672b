"""The engines: each starts from terms, by its own way, and knows of no other one."""
