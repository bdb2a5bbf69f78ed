"""The study of dufour2020: its scenarios, table and claims on Baxter's left arm, and what the tracker makes of them."""
