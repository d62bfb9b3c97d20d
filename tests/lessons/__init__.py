"""What holds of the exercises of one lesson alone, a file for each lesson."""
