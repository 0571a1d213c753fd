package frustum.mutation

/** The units that are put to the test, by what they are called on the command line. */
object MutationPlans {
  val all: Seq[(String, Long => MutationPlan)] = Seq(
    "edge-walker" -> EdgeWalkerPlan.serial,
    "parallel-walker" -> EdgeWalkerPlan.parallel,
    "perspective-divide" -> PerspectiveDividePlan.apply,
    "depth-test" -> DepthStagePlan.apply,
    "blend" -> BlendPlan.apply
  )
}
