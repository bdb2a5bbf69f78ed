"""follow_target: a target that is dragged in the browser, and the controller that follows it in real time."""
