"""The page of a study: one self-contained file, with charts that are brushed and cases that are simulated again."""
