"""Pictures of pdrun's results."""
