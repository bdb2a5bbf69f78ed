"""The study of dufour2020: its scenarios, table and claims, reproduced with the tracker on Baxter's left arm."""
