# Sourced by run.sh and coverage/run.sh: tests that take minutes when Clang instruments the code. They are comparisons on
# real meshes in OpenMesh's connectivity, repeated runs on the bunny, measurements on large meshes, brute force on larger
# meshes, and repeated distance measurements.
slow_tests='^(Accuracy|Package)\.|(StockArithmetic|DriverAgreement)OnRealMesh|BunnyInvariance|ContractionOrder.*/(knot406|insideoutblob|noisysphere2|blob2|sphere2|terrain11)( |$)|SurfaceDistance\.(ScalesWithTheUnit|DoesNotDependOnThePlace|ConvergesAtAny)|(FitsSmoothSurfaces|LessenTheError|ErrsLessThanPlainQuadrics|BringsDownWhatIsAskedFor|BringTheResultNearer|TakesTheNearerOfTwoResultsWhereMuchIsFlat|Certify.IsRightForSimplifiedMeshes)$'
