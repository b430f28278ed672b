"""Order between terms: what shows in their form, and what balls prove."""
