"""Reports: the grades as tables and pages, for the instructor and for each student."""
