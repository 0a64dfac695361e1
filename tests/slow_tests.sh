# Sourced by run.sh and coverage/run.sh: tests that take minutes when Clang instruments the code. They are comparisons on
# real meshes in OpenMesh's connectivity, repeated runs on the bunny, measurements on large meshes, brute force on larger
# meshes, repeated distance measurements, and proofs of many results.
#
# One expression a line, without groups: CMake knows nine at most, and runs every test when an expression has more.
slow_tests=$(
  paste --serial --delimiters='|' <<'END'
^Accuracy\.
^Package\.
^ModMaxError\.
^ModMaxErrorBesideModHausdorff\.
^WithinError\.
StockArithmeticOnRealMesh
DriverAgreementOnRealMesh
BunnyInvariance
ReplayOnRealMesh
Replay\.HasUsableLevels
ContractionOrder.*/knot406
ContractionOrder.*/insideoutblob
ContractionOrder.*/noisysphere2
ContractionOrder.*/blob2
ContractionOrder.*/sphere2
ContractionOrder.*/terrain11
KeptByPolish\.RoundTriangles$
KeptByPolish\.FeatureTolerance$
LinearAttributes\.StayLinearAtEveryEffort
SurfaceDistance\.ScalesWithTheUnit
SurfaceDistance\.DoesNotDependOnThePlace
SurfaceDistance\.ConvergesAtAny
FitsSmoothSurfaces$
LessenTheError$
ErrsLessThanPlainQuadrics$
BringsDownWhatIsAskedFor$
BringTheResultNearer$
ErrHardlyMoreThanOnePassOverAll$
IntersectionGuard\.KeepsPartsApart$
TakesTheNearerOfTwoResultsWhereMuchIsFlat$
Certify\.IsRightForSimplifiedMeshes$
Certify\.IsRightInRationalArithmetic$
MaxError\.IsKeptByAllCosts$
MaxError\.TakesFewFaces$
MaxError\.GoesFarOnFlatGroundWithHoles$
VerifyRandom\.ProvesNothingFalseOfClosedSurfaces$
Mutations\.OfMeshesProveNothingFalse$
SimplifyToLevels\.IsAsAccurateAsARunToEachLevel$
BlocksInExactOrder\.GiveWhatOnePassGives$
RealCertificates\.Hold$
DistanceMap\.IsNearlyRightInside$
DistanceMap\.CutsFacesAndLeavesTheSurface$
END
)
