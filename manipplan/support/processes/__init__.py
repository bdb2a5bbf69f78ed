"""Processes and threads: commands with a time limit, workers that are replaced when lost, linear algebra on one thread."""
